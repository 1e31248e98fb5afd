"""Positions at the edge: urdfctl counts lines and code points from 1, an editor from 0 in units that it chooses."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence

from lsprotocol import types
from pygls import uris

from urdfctl.diagnostic import Location
from urdfctl.source.files import first_bytes
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from pygls.workspace import PositionCodec

_MAX_BYTES = 16 << 20


def path_of(uri: str) -> str | None:
    """Return the path of a file's URI, with all links followed; None for what is no file, such as an unnamed buffer."""
    path = uris.to_fs_path(uri) if uri.startswith("file:") else None
    return os.path.realpath(path) if path else None


def uri_of(path: str) -> str:
    """Return the URI of a file."""
    return uris.from_fs_path(path) or ""


def _lines(data: bytes) -> list[str]:
    """Part a text where the protocol does: at LF, CRLF and CR, and not at a form feed."""
    return re.split(r"(?<=\n)|(?<=\r)(?!\n)", data.decode("utf-8", "replace").removeprefix("\ufeff"))


class Positions:
    """Converts positions in files.

    text_of: returns the open text of a file, by its real path; None if it is not open.
    """

    def __init__(self, codec: PositionCodec, text_of: Callable[[str], bytes | None]) -> None:
        self._codec, self._text_of = codec, text_of
        self._lines: dict[str, Sequence[str]] = {}

    def lines(self, path: str) -> Sequence[str]:
        """Return the lines of a file, with their ends; none if it cannot be read."""
        real = os.path.realpath(path)
        if real not in self._lines:
            data = self._text_of(real)
            if data is None:
                try:
                    data = first_bytes(real, _MAX_BYTES)
                except OSError:
                    data = b""
            self._lines[real] = _lines(data)
        return self._lines[real]

    def range_of(self, at: Location) -> types.Range:
        """Return the range of a location, in the editor's units."""
        return self._codec.range_to_client_units(
            self.lines(at.file),
            types.Range(
                types.Position(at.line - 1, at.column - 1),
                types.Position(at.end_line - 1, at.end_column - 1),
            ),
        )

    def position_of(self, path: str, line: int, column: int) -> types.Position:
        """Return the editor's position for a line and a column, both from 1, in code points."""
        return self._codec.position_to_client_units(self.lines(path), types.Position(line - 1, column - 1))

    def location_of(self, at: Location) -> types.Location:
        """Return a location with its file, in the editor's units."""
        return types.Location(uri_of(at.file), self.range_of(at))

    def line_and_column(self, path: str, position: types.Position) -> tuple[int, int]:
        """Return the line and the column of an editor's position, both from 1, in code points."""
        found = self._codec.position_from_client_units(self.lines(path), position)
        return found.line + 1, found.character + 1
