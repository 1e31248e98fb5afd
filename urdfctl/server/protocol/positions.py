"""Positions at the edge: urdfctl counts lines and code points from 1, an editor from 0 in units that it chooses."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from lsprotocol import types

from urdfctl.diagnostic import Location
from urdfctl.server.protocol.uris import uri_of
from urdfctl.source.disk.files import MAX_BYTES, first_bytes

if TYPE_CHECKING:
    from pygls.workspace import PositionCodec


def lines_of(text: str) -> list[str]:
    """Part a text where the protocol does: at LF, CRLF and CR, and not at a form feed."""
    lines = list(io.StringIO(text, newline=""))
    return lines if lines and not lines[-1].endswith(("\n", "\r")) else [*lines, ""]


_ENCODINGS = {
    types.PositionEncodingKind.Utf8: ("utf-8", 1),
    types.PositionEncodingKind.Utf16: ("utf-16-le", 2),
    types.PositionEncodingKind.Utf32: ("utf-32-le", 4),
}
"""For each unit of an editor's positions, the encoding and its size in bytes."""


class Units:
    """The units in which an editor counts. The codec's own functions take seconds for a line of a megabyte."""

    def __init__(self, codec: PositionCodec) -> None:
        self._encoding, self._size = _ENCODINGS[types.PositionEncodingKind(codec.encoding)]

    def count(self, text: str) -> int:
        """Return how many units a text has."""
        return len(text) if text.isascii() else len(text.encode(self._encoding, "surrogatepass")) // self._size

    def points(self, text: str, units: int) -> int:
        """Return how many code points are in the first units of a text."""
        first = text[:units].encode(self._encoding, "surrogatepass")
        return len(first[: units * self._size].decode(self._encoding, "ignore"))

    def joined(self, before: str, start: int, text: str, after: str, end: int) -> str:
        """Return the first `start` units of a text, another text, and what follows the first `end` units of a third.

        The halves of a character that an editor changed one by one come together.
        """
        first, middle, last = (one.encode(self._encoding, "surrogatepass") for one in (before, text, after))
        data = first[: start * self._size] + middle + last[end * self._size :]
        return data.decode(self._encoding, "replace" if self._size == 1 else "surrogatepass")


class Positions:
    """Converts positions in files.

    text_of: returns the open text of a file, by its real path; None if it is not open.
    """

    def __init__(self, codec: PositionCodec, text_of: Callable[[str], bytes | None]) -> None:
        self._units = Units(codec)
        self._text_of = text_of
        self._lines: dict[str, Sequence[str]] = {}

    def lines(self, path: str) -> Sequence[str]:
        """Return the lines of a file, with their ends; none if it cannot be read."""
        real = os.path.realpath(path)
        if real not in self._lines:
            data = self._text_of(real)
            if data is None:
                try:
                    data = first_bytes(real, MAX_BYTES)
                except OSError:
                    data = b""
            self._lines[real] = lines_of(data.decode("utf-8", "replace").removeprefix("\ufeff"))
        return self._lines[real]

    def range_of(self, at: Location) -> types.Range:
        """Return the range of a location, in the editor's units."""
        start = self.position_of(at.file, at.line, at.column)
        return types.Range(start, self.position_of(at.file, at.end_line, at.end_column))

    def position_of(self, path: str, line: int, column: int) -> types.Position:
        """Return the editor's position for a line and a column, both from 1, in code points."""
        lines = self.lines(path)
        if line > len(lines):
            return types.Position(len(lines), 0)
        return types.Position(line - 1, self._units.count(lines[line - 1][: column - 1]))

    def location_of(self, at: Location) -> types.Location:
        """Return a location with its file, in the editor's units."""
        return types.Location(uri_of(at.file), self.range_of(at))

    def line_and_column(self, path: str, position: types.Position) -> tuple[int, int]:
        """Return the line and the column of an editor's position, both from 1, in code points: at most the end."""
        lines = self.lines(path)
        line = min(position.line, len(lines) - 1)
        text = lines[line].rstrip("\r\n")
        return line + 1, 1 + (self._units.points(text, position.character) if line == position.line else len(text))
