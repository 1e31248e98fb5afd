"""Compare texts loosely: without quotes, articles, contractions and capitals, which people and releases change."""

from __future__ import annotations

import re
import string

_UPPER = str.maketrans(string.ascii_uppercase, string.ascii_lowercase)
_REPEATED = re.compile(r"\bu(?=['\"])|['\"\\]|\b(?:the|an|a)(?= )", re.IGNORECASE)
_NOT = re.compile(r"\b(can)not\b|\b(can|could|does|do|did|is|was|were|has|should|would)n[’']?t\b", re.IGNORECASE)  # noqa: RUF001


def loosened(text: str) -> str:
    """Return a text without quotes and articles, and with "not" written out."""
    text = _NOT.sub(lambda found: f"{found[1] or found[2]} not", text)
    return _REPEATED.sub("", text)


def lower(text: str) -> str:
    """Return a text in small letters, of the same length: only the letters of ASCII have changed."""
    return text.translate(_UPPER)
