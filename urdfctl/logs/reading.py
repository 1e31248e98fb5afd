"""Reads the lines of a log of any size: no more of it, and of each line, than there is use for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import BinaryIO

MOST_BYTES = 64 << 20
"""How much of a log is read: half a million lines and more."""
LONGEST_LINE = 4096
"""How much of a line is read, in bytes; what ROS prints is shorter, but for lists of plugins."""
_CHUNK = 1 << 16
_ESCAPE = re.compile(r"\x1b(?:\[[0-9;:?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\)?|[@-Z\\^_])")


class Lines:
    """The lines of a stream, without colours and without what is beyond their limits."""

    def __init__(self, stream: BinaryIO, most_bytes: int = MOST_BYTES) -> None:
        self._stream = stream
        self._left = most_bytes
        self.complete = True
        """Whether all that the stream holds was read."""

    def __iter__(self) -> Iterator[str]:
        begun = b""
        for chunk in self._chunks():
            *whole, rest = chunk.split(b"\n")
            for line in whole:
                yield _text(begun + line if begun else line)
                begun = b""
            begun = (begun + rest)[:LONGEST_LINE]
        if begun:
            yield _text(begun)

    def _chunks(self) -> Iterator[bytes]:
        try:
            while self._left > 0:
                chunk = self._stream.read1(min(_CHUNK, self._left))  # type: ignore[attr-defined]
                if not chunk:
                    return
                self._left -= len(chunk)
                yield chunk
            self.complete = not self._stream.read(1)
        except KeyboardInterrupt:  # the end of a log that is still being written
            self.complete = False


def _text(line: bytes) -> str:
    text = line[:LONGEST_LINE].decode("utf-8", "replace")
    return _ESCAPE.sub("", text) if "\x1b" in text else text
