"""Positions at the edge: urdfctl counts lines and code points from 1, an editor from 0 in units that it chooses."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Sequence

from lsprotocol import types
from pygls import uris

from urdfctl.diagnostic import Location
from urdfctl.source.files import MAX_BYTES, first_bytes
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from pygls.workspace import PositionCodec


def path_of(uri: str) -> str | None:
    """Return the path of a file's URI, with all links followed; None for what is no file, such as an unnamed buffer."""
    path = uris.to_fs_path(uri) if uri.startswith("file:") else None
    return os.path.realpath(path) if path else None


def uri_of(path: str) -> str:
    """Return the URI of a file."""
    return uris.from_fs_path(path) or ""


def _lines(data: bytes) -> list[str]:
    """Part a text where the protocol does: at LF, CRLF and CR, and not at a form feed."""
    lines = list(io.StringIO(data.decode("utf-8", "replace").removeprefix("\ufeff"), newline=""))
    return lines if lines and not lines[-1].endswith(("\n", "\r")) else [*lines, ""]


_ENCODINGS = {
    types.PositionEncodingKind.Utf8: ("utf-8", 1),
    types.PositionEncodingKind.Utf16: ("utf-16-le", 2),
    types.PositionEncodingKind.Utf32: ("utf-32-le", 4),
}
"""For each unit of an editor's positions, the encoding and its size in bytes."""


class Positions:
    """Converts positions in files. The codec's own functions take seconds for a line of a megabyte.

    text_of: returns the open text of a file, by its real path; None if it is not open.
    """

    def __init__(self, codec: PositionCodec, text_of: Callable[[str], bytes | None]) -> None:
        self._encoding, self._size = _ENCODINGS[types.PositionEncodingKind(codec.encoding)]
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
            self._lines[real] = _lines(data)
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
        return types.Position(line - 1, self._units(lines[line - 1][: column - 1]))

    def location_of(self, at: Location) -> types.Location:
        """Return a location with its file, in the editor's units."""
        return types.Location(uri_of(at.file), self.range_of(at))

    def line_and_column(self, path: str, position: types.Position) -> tuple[int, int]:
        """Return the line and the column of an editor's position, both from 1, in code points: at most the end."""
        lines = self.lines(path)
        line = min(position.line, len(lines) - 1)
        text = lines[line].rstrip("\r\n")
        return line + 1, 1 + (self._points(text, position.character) if line == position.line else len(text))

    def _units(self, text: str) -> int:
        return len(text) if text.isascii() else len(text.encode(self._encoding)) // self._size

    def _points(self, text: str, units: int) -> int:
        """How many code points are in the first units of a text."""
        return len(text[:units].encode(self._encoding)[: units * self._size].decode(self._encoding, "ignore"))
