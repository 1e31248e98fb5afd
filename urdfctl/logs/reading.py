"""Read the lines of a log of any size, with limits for the log and for each line."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import BinaryIO

MOST_BYTES = 64 << 20
"""The maximum number of bytes read from a log: more than half a million lines."""
LONGEST_LINE = 4096
"""The maximum number of bytes read from a line. ROS prints shorter lines, except for lists of plugins."""
_CHUNK = 1 << 16
_ESCAPE = re.compile(r"\x1b(?:\[[0-9;:?]*[ -/]*[@-~]|\][^\x07\x1b]*(?:\x07|\x1b\\)?|[@-Z\\^_])")


class Lines:
    """The lines of a stream, without colour codes and up to the limits."""

    def __init__(self, stream: BinaryIO, most_bytes: int = MOST_BYTES) -> None:
        self._stream = stream
        self._left = most_bytes
        self.complete = True
        """Whether the whole stream was read."""

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
        except KeyboardInterrupt:  # the user stops reading a log that is still being written
            self.complete = False


def _text(line: bytes) -> str:
    text = line[:LONGEST_LINE].decode("utf-8", "replace")
    return _ESCAPE.sub("", text) if "\x1b" in text else text
