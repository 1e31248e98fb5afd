"""The texts of rules and catalogues as Markdown."""

from __future__ import annotations

import re


def as_markdown(text: str) -> str:
    """Return a text as Markdown: `<joint>` outside of code is shown, and not read as HTML."""
    return re.sub(r"(`[^`]*`)|<", lambda match: match[1] or "&lt;", text)
