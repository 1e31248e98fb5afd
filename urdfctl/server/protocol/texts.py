"""The texts of an editor, changed as it changes them."""

from __future__ import annotations

import sys
from collections.abc import Iterable

from lsprotocol import types

from urdfctl.server.protocol.positions import Units, lines_of


def changed(text: str, changes: Iterable[types.TextDocumentContentChangeEvent], units: Units) -> str:
    """Return a text after some changes, each of the text that the one before it left.

    A place after the end of a line or of the text is that end, as the protocol has it.
    """
    for change in changes:
        if isinstance(change, types.TextDocumentContentChangePartial):
            text = _replaced(text, change, units)
        else:
            text = change.text
    return text


def _replaced(text: str, change: types.TextDocumentContentChangePartial, units: Units) -> str:
    lines = lines_of(text)
    last = len(lines) - 1
    places = ((at.line, at.character) for at in (change.range.start, change.range.end))
    start, end = sorted(place if place[0] <= last else (last, sys.maxsize >> 3) for place in places)
    before, after = (lines[line].rstrip("\r\n") for line, _ in (start, end))
    joined = units.joined(before, start[1], change.text, after, end[1])
    line_end = lines[end[0]][len(after) :]
    return "".join([*lines[: start[0]], joined, line_end, *lines[end[0] + 1 :]])
