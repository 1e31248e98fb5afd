"""Edits of files: whether they conflict, the bytes that they produce, and how they move the other bytes."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from itertools import accumulate, pairwise

from urdfctl.startup.records import NamedTuple


class Splice(NamedTuple):
    """A replacement of bytes `start` to `end` of a file by `text`. `file` is the path with all links resolved."""

    file: str
    start: int
    end: int
    text: str


def edited(data: bytes, edits: Iterable[Splice]) -> bytes:
    """Return the bytes after edits, which must not clash. ValueError if an edit is out of range."""
    parts: list[bytes] = []
    position = 0
    for edit in sorted(edits, key=_order):
        if not position <= edit.start <= edit.end <= len(data):
            raise ValueError(f"bytes {edit.start} to {edit.end} do not exist")
        parts += [data[position : edit.start], edit.text.encode("utf-8", "surrogateescape")]
        position = edit.end
    return b"".join([*parts, data[position:]])


def _order(edit: Splice) -> tuple[int, int]:
    return edit.start, edit.end


def clash(one: Splice, other: Splice) -> bool:
    """Return whether only one of two edits can be made.

    They clash if they share bytes, or if one inserts text where the other begins or ends, so that their order is
    undefined. An edit does not clash with itself.
    """
    if one == other or one.file != other.file:
        return False
    if one.start == one.end or other.start == other.end:
        return one.start <= other.end and other.start <= one.end
    return one.start < other.end and other.start < one.end


class Taken:
    """The accepted edits. Further edits are accepted only if they clash with none of them."""

    def __init__(self) -> None:
        self._edits: dict[str, list[Splice]] = {}

    def take(self, edits: Iterable[Splice]) -> bool:
        """Accept all these edits and return True, or none of them if one clashes."""
        new = sorted({edit for edit in edits if edit not in self._of(edit)})
        if any(clash(earlier, later) for earlier, later in pairwise(new)):
            return False
        if any(clash(edit, near) for edit in new for near in self._near(edit)):
            return False
        for edit in new:
            taken = self._of(edit)
            taken.insert(bisect_left(taken, _order(edit), key=_order), edit)
        return True

    def _of(self, edit: Splice) -> list[Splice]:
        return self._edits.setdefault(edit.file, [])

    def _near(self, edit: Splice) -> list[Splice]:
        """The accepted edits next to this one. Others cannot clash, because the accepted edits do not overlap."""
        taken = self._of(edit)
        at = bisect_left(taken, _order(edit), key=_order)
        return taken[max(at - 2, 0) : at + 2]


class Shift:
    """Maps offsets in a file before edits to offsets after them."""

    def __init__(self, edits: Iterable[Splice]) -> None:
        self.edits = sorted(edits, key=_order)
        grown = [len(edit.text.encode("utf-8", "surrogateescape")) - (edit.end - edit.start) for edit in self.edits]
        self._starts = [edit.start for edit in self.edits]
        self._moved = [0, *accumulate(grown)]
        self._new = [
            (edit.start + moved, edit.end + moved + growth)
            for edit, moved, growth in zip(self.edits, self._moved, grown, strict=False)
        ]
        self._new_starts = [start for start, _ in self._new]

    def of(self, offset: int) -> int | None:
        """Return the new offset of a byte, None if it is replaced."""
        index = bisect_right(self._starts, offset)
        if index and offset < self.edits[index - 1].end:
            return None
        return offset + self._moved[index]

    def replacing(self, offset: int) -> list[Splice]:
        """Return the edit that replaces a byte, as a list of at most one."""
        return [] if self.of(offset) is not None else [self.edits[bisect_right(self._starts, offset) - 1]]

    def near(self, offset: int) -> int:
        """Return the new offset of a byte, or that of its replacement."""
        moved = self.of(offset)
        return self._new[bisect_right(self._starts, offset) - 1][0] if moved is None else moved

    def is_new(self, offset: int) -> bool:
        """Return whether an edit inserted the byte at an offset of the edited file."""
        index = bisect_right(self._new_starts, offset)
        return bool(index) and offset < self._new[index - 1][1]
