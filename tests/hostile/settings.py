"""Configuration files that cannot be read: the text, and what is said about it."""

from __future__ import annotations

REFUSED_SETTINGS = {
    "keys of endless parts": ("a." * 9000, "invalid TOML: a line with more than 4000 dots"),
    "a number of endless digits": (f"a = {'9' * 5000}", "invalid TOML: Exceeds the limit"),
}
