"""Writes launch files in each of their languages, and the nodes in them."""
