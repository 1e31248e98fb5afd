"""`urdfctl why`: where a value of a robot comes from, and what uses it."""
