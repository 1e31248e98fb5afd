"""Edits of files: which go together, what they make of a file's bytes, and where its other bytes come to stand."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from itertools import accumulate, pairwise

from urdfctl.record import NamedTuple


class Splice(NamedTuple):
    """Bytes `start` to `end` of a file become `text`. The file is named by its path with all links followed."""

    file: str
    start: int
    end: int
    text: str


def edited(data: bytes, edits: Iterable[Splice]) -> bytes:
    """The bytes with edits made that do not clash. ValueError where one lies outside of them."""
    parts: list[bytes] = []
    position = 0
    for edit in sorted(edits, key=_order):
        if not position <= edit.start <= edit.end <= len(data):
            raise ValueError(f"no bytes {edit.start} to {edit.end} to be replaced")
        parts += [data[position : edit.start], edit.text.encode("utf-8", "surrogateescape")]
        position = edit.end
    return b"".join([*parts, data[position:]])


def _order(edit: Splice) -> tuple[int, int]:
    return edit.start, edit.end


def clash(one: Splice, other: Splice) -> bool:
    """Whether only one of two edits can be made: they share bytes, or one puts text where the other begins or ends, so
    that their order would be anybody's guess. An edit goes with itself."""
    if one == other or one.file != other.file:
        return False
    if one.start == one.end or other.start == other.end:
        return one.start <= other.end and other.start <= one.end
    return one.start < other.end and other.start < one.end


class Taken:
    """The edits that were chosen so far; others go with them only where they clash with none."""

    def __init__(self) -> None:
        self._edits: dict[str, list[Splice]] = {}

    def take(self, edits: Iterable[Splice]) -> bool:
        """Take all of some edits, if they go with what was taken and with each other; else none of them."""
        new = sorted({edit for edit in edits if edit not in self._of(edit)})
        if any(clash(one, other) for one, other in pairwise(new)):
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
        """The edits next to one: as none of them clash, no others can."""
        taken = self._of(edit)
        at = bisect_left(taken, _order(edit), key=_order)
        return taken[max(at - 2, 0) : at + 2]


class Shift:
    """Where the bytes of a file come to stand when edits are made in it."""

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
        """The new offset of a byte; None where it is replaced."""
        index = bisect_right(self._starts, offset)
        if index and offset < self.edits[index - 1].end:
            return None
        return offset + self._moved[index]

    def replacing(self, offset: int) -> list[Splice]:
        """The edit that replaces a byte, if there is one."""
        return [] if self.of(offset) is not None else [self.edits[bisect_right(self._starts, offset) - 1]]

    def near(self, offset: int) -> int:
        """The new offset of a byte; where it is replaced, that of what replaces it."""
        found = self.of(offset)
        return self._new[bisect_right(self._starts, offset) - 1][0] if found is None else found

    def is_new(self, offset: int) -> bool:
        """Whether the byte at an offset of the edited file was brought by an edit."""
        index = bisect_right(self._new_starts, offset)
        return bool(index) and offset < self._new[index - 1][1]
