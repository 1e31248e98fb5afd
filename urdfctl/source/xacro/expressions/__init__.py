"""Expressions in `${...}`: what is allowed, and how much work they may make."""
