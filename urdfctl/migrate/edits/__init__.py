"""Edits of XML, YAML and Python files that keep what people wrote around them."""
