"""Pieces of texts that a reader of a report could obey: a terminal, a runner of CI, a browser, a parser."""

from __future__ import annotations

OBEYED = ["]]>", "%0A", "::error::", "\r\n", "\x1b[2J", "\u2028", "{0}", "[a](b)", "&lt;", '"', "'", ",", "\\", "\x00"]
