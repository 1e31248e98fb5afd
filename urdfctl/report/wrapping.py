"""Wrap lines of the text report."""

from __future__ import annotations

_INDENT = "    "


def wrapped(text: str, width: int, before: int = 0) -> str:
    """Return a text in lines of at most `width` columns, further lines indented, with a newline at the end.

    Names that are wider are cut: a finding must not disturb the layout of a terminal. before: how many columns of the
    first line are taken.
    """
    if before + len(text) <= width:
        return f"{text}\n"
    lines: list[str] = []
    rest, room = text, width - before
    while len(rest) > room:
        cut = rest.rfind(" ", 1, room + 1)
        is_start = not rest[:cut].strip() if cut > 0 else True
        if is_start:  # no space where the line could end
            cut = 0 if lines == [] and before else room
        lines.append(rest[:cut].rstrip())
        rest, room = _INDENT + rest[cut:].lstrip(), width
    return "\n".join([*lines, rest]) + "\n"
