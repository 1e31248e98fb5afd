"""Expand descriptions, as well as possible without what is missing."""
