"""Which text each value of an expanded robot was evaluated from."""
