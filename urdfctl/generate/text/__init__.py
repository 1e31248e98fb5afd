"""How values, parameters and templates become text."""
