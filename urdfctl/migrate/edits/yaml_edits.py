"""Edits of entries in YAML maps that keep comments, order and formatting."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping as Map

from urdfctl.diagnostic import Edit
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, YamlEntry

Path = tuple[tuple[Mapping, YamlEntry], ...]
"""The maps and entries that lead to a value."""
ByName = Map[str, Path]
"""The parameters of a section by their dotted names."""


class MapEdits:
    """Collects changes of the entries of maps in one file."""

    def __init__(self, source: SourceText) -> None:
        self.source = source
        self._splices: list[tuple[int, int, str]] = []
        self._inserted: dict[int, int] = {}
        self._dropped: dict[int, set[int]] = {}

    def replace(self, node: Node, text: str) -> None:
        """Replace a key or a value."""
        self._splices.append((node.start, _end(node), text))

    def insert(self, parent: Mapping, line: str, *, after: YamlEntry | None = None) -> None:
        """Insert `key: value` into a map: after an entry of it, or at its end."""
        entry = after or (parent.entries[-1] if parent.entries else None)
        self._inserted[parent.start] = self._inserted.get(parent.start, 0) + 1
        if entry is None:
            self._splices.append((parent.start + 1, parent.start + 1, line))
        elif self._is_flow(parent):
            self._splices.append((_end(entry.value), _end(entry.value), f", {line}"))
        else:
            at = self._line_end(_end(entry.value))
            indent = " " * (parent.entries[0].key.start - self._line_start(parent.entries[0].key.start))
            has_newline = self.source.data[at - 1 : at] == b"\n"
            text = f"{indent}{line}\n" if has_newline else f"\n{indent}{line}"
            self._splices.append((at, at, text))

    def drop(self, path: Path) -> None:
        """Remove the last entry of a path of maps and entries, and each entry whose map has none left then."""
        for parent, entry in reversed(path):
            gone = self._dropped.setdefault(parent.start, set())
            gone.add(entry.key.start)
            if len(gone) < len(parent.entries) or self._inserted.get(parent.start) or parent is path[0][0]:
                self._remove(parent, entry)
                return

    def edits(self) -> tuple[Edit, ...]:
        """Return the edits; those that touch each other are one."""
        merged: list[tuple[int, int, str]] = []
        for start, end, text in sorted(self._splices, key=_order):
            if merged and start < merged[-1][1]:  # a part of what is removed already
                continue
            if merged and start == merged[-1][1]:
                merged[-1] = merged[-1][0], end, merged[-1][2] + text
            else:
                merged.append((start, end, text))
        return tuple(Edit(SourceSpan(self.source, start, end), text) for start, end, text in merged)

    def _remove(self, parent: Mapping, entry: YamlEntry) -> None:
        """Remove an entry with its line; earlier removals of its parts are forgotten."""
        start, end = entry.key.start, _end(entry.value)
        if self._is_flow(parent):
            index = parent.entries.index(entry)
            if index + 1 < len(parent.entries):
                end = parent.entries[index + 1].key.start
            elif index:
                start = _end(parent.entries[index - 1].value)
        elif not self.source.data[self._line_start(start) : start].strip():
            start, end = self._line_start(start), self._line_end(end)
        self._splices = [one for one in self._splices if not start <= one[0] < end or one[:2] == (start, start)]
        self._splices.append((start, end, ""))

    def _is_flow(self, parent: Mapping) -> bool:
        return self.source.data[parent.start : parent.start + 1] == b"{"

    def _line_start(self, offset: int) -> int:
        return self.source.data.rfind(b"\n", 0, offset) + 1

    def _line_end(self, offset: int) -> int:
        """The offset after the end of the line that an offset is in."""
        found = self.source.data.find(b"\n", offset)
        return len(self.source.data) if found < 0 else found + 1


def _order(splice: tuple[int, int, str]) -> tuple[int, int, int]:
    """The order of edits; lines that are inserted at one place belong to the inner map first."""
    start, end, text = splice
    return start, end, len(text.lstrip()) - len(text) if start == end else 0


def _end(node: Node) -> int:
    """The end of a node's own text, without what follows a block collection."""
    data = node.source.data[node.start : node.end]
    return node.start + len(data.rstrip())


def leaves(parent: Mapping, path: Path = ()) -> Iterator[tuple[str, Path]]:
    """Yield each parameter below a map by its dotted name, with the maps and entries that lead to it."""
    for entry in parent.entries:
        here = (*path, (parent, entry))
        if isinstance(entry.value, Mapping) and entry.value.entries:
            yield from leaves(entry.value, here)
        else:
            yield ".".join(one.key.text for _, one in here), here


def deepest(root: Mapping, name: str) -> tuple[Mapping, str]:
    """Return the innermost map that a dotted name leads to, and the rest of the name, as a dotted key in it."""
    parent, rest = root, name
    while True:
        found = next((entry for entry in parent.entries if rest.startswith(f"{entry.key.text}.")), None)
        if found is None or not isinstance(found.value, Mapping):
            return parent, rest
        parent, rest = found.value, rest.removeprefix(f"{found.key.text}.")


def text_at(given: ByName, name: str) -> str:
    """Return the text of a parameter; empty if it is not set, or is a list."""
    value = given[name][-1][1].value if name in given else None
    return value.text if isinstance(value, Scalar) else ""


def texts_at(given: ByName, name: str) -> list[str]:
    """Return the texts of a parameter that is a list."""
    value = given[name][-1][1].value if name in given else None
    return [item.text for item in value.items if isinstance(item, Scalar)] if isinstance(value, Sequence) else []
