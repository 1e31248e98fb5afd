"""Read a unified diff as `urdfctl migrate` prints it: what is replaced in which file."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.startup.records import NamedTuple

_HUNK = re.compile(rb"@@ -(\d+)(?:,(\d+))? \+\d+(?:,\d+)? @@")
_ESCAPED = re.compile(rb'\\([\\"ntr])')
_ESCAPES = {b"\\": b"\\", b'"': b'"', b"n": b"\n", b"t": b"\t", b"r": b"\r"}


class LineEdit(NamedTuple):
    """Lines that are replaced: from `start` up to, but without `end`, from 0; lines end at LF."""

    start: int
    end: int
    text: bytes


class PatchedFile(NamedTuple):
    """A file that a patch changes.

    path: as in the patch, without its prefix `a/` or `b/`.
    """

    path: bytes
    edits: tuple[LineEdit, ...]
    is_new: bool = False
    is_deleted: bool = False

    def applied(self, before: bytes) -> bytes:
        """Return a text with the edits."""
        lines = before.split(b"\n")
        lines = [line + b"\n" for line in lines[:-1]] + lines[-1:]
        for edit in reversed(self.edits):
            lines[edit.start : edit.end] = [edit.text]
        return b"".join(lines)


def read_patch(patch: bytes) -> list[PatchedFile]:
    """Return the files that a unified diff changes, in order."""
    lines = patch.split(b"\n")
    starts = [number for number in range(len(lines)) if _begins(lines, number)]
    ends = [*starts[1:], len(lines)]
    return [_file(lines[start : ends[number]]) for number, start in enumerate(starts)]


def _begins(lines: list[bytes], number: int) -> bool:
    """Whether a file begins at a line, which is no deleted line that looks like it."""
    first, second, third = [*lines[number : number + 3], b"", b""][:3]
    if first.startswith(b"diff --git "):
        header = b"--- /dev/null" if second.startswith(b"new file mode") else b"--- " + _both(first)[0]
        return third.rstrip(b"\t") != header
    return first.startswith(b"--- ") and second.startswith(b"+++ ") and _HUNK.match(third) is not None


def _file(lines: list[bytes]) -> PatchedFile:
    if lines[0].startswith(b"diff --git "):  # an empty file
        is_new = lines[1].startswith(b"new")
        return PatchedFile(_name(_both(lines[0])[1]), (), is_new=is_new, is_deleted=not is_new)
    old, new = _name(lines[0][4:]), _name(lines[1][4:])
    return PatchedFile(new or old, tuple(_edits(lines[2:])), is_new=not old, is_deleted=not new)


def _both(line: bytes) -> tuple[bytes, bytes]:
    """Both names of a new or deleted file, which are equally long."""
    names = line.removeprefix(b"diff --git ")
    return names[: len(names) // 2], names[len(names) // 2 + 1 :]


def _name(name: bytes) -> bytes:
    """The path in a header; empty for a file that does not exist on that side."""
    name = name.rstrip(b"\t")
    if name.startswith(b'"'):
        name = _ESCAPED.sub(lambda match: _ESCAPES[match[1]], name[1:-1])
    return b"" if name == b"/dev/null" else name[2:]


def _edits(lines: list[bytes]) -> Iterator[LineEdit]:
    """The edits of a file's hunks: one for each run of lines that differ."""
    line = start = 0
    new: list[bytes] = []
    is_added = False
    for text in lines:
        hunk = _HUNK.match(text)
        if hunk is not None or text[:1] == b" ":
            if new or line > start:
                yield LineEdit(start, line, b"".join(new))
            new, is_added = [], False
            line = line + 1 if hunk is None else int(hunk[1]) - (hunk[2] != b"0")
            start = line
        elif text[:1] == b"-":
            line, is_added = line + 1, False
        elif text[:1] == b"+":
            new.append(text[1:] + b"\n")
            is_added = True
        elif text[:1] == b"\\" and is_added:
            new[-1] = new[-1][:-1]
    if new or line > start:
        yield LineEdit(start, line, b"".join(new))
