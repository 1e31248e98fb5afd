"""The line ends of a file, which what is written into it gets too, so that steps need not care."""

from __future__ import annotations

import re


def with_line_ends_of(data: bytes, text: str) -> str:
    """Return a text with CRLF at the ends of its lines if most lines of a file end so."""
    is_crlf = 2 * data.count(b"\r\n") > data.count(b"\n")
    return re.sub(r"(?<!\r)\n", "\r\n", text) if is_crlf and "\n" in text else text
