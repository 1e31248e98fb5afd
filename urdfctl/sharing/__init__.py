"""Lints one robot in two processes at once, where there are processors for both."""
