"""Parse YAML into a located tree, in which every key, value and element knows its bytes.

Values are texts; `yaml_types` types them as their reader does.

The tree is built from the parser's events, without recursion and within limits. A file of nested brackets would crash
the C library's own composer, and a few aliases of aliases can expand to more than any memory.
"""

from __future__ import annotations

import re
from typing import Any

from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.span import BOM, Place, SourceText
from urdfctl.source.yaml.size import TOO_DEEP
from urdfctl.startup.lazy_yaml import SAFE_LOADER, yaml
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple

MOST_DEPTH = 64
MOST_NODES = 200_000
_MOST_DUPLICATES = 20
_MOST_TAGS = 20
_REFUSED = "Python's safe YAML reader, which reads this file, rejects it. Remove the tag"
_UNPRINTABLE = "[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"
_TAB_INDENT = r" *\t[ \t]*(?=[^\s#])"
_PYTHON = "tag:yaml.org,2002:python/"
_OPENED = ("while parsing a flow", "while scanning a quoted")


class Scalar(NamedTuple):
    """A scalar.

    text: its text, without quotes.
    style: `'`, `"`, `|` or `>`; empty for a plain scalar.
    tag: the explicit tag; None if it has none.
    start, end: byte offsets, including quotes.
    """

    text: str
    style: str
    tag: str | None
    source: SourceText
    start: int
    end: int

    @property
    def at(self) -> Place:
        """The place of the scalar, including quotes."""
        return Place(self.source, self.start, end=self.end)


class Sequence(NamedTuple):
    """A list."""

    items: tuple[Node, ...]
    tag: str | None
    source: SourceText
    start: int
    end: int

    @property
    def at(self) -> Place:
        """The place of the whole list."""
        return Place(self.source, self.start, end=self.end)


class Mapping(NamedTuple):
    """A map: its entries in order, including duplicate keys."""

    entries: tuple[YamlEntry, ...]
    tag: str | None
    source: SourceText
    start: int
    end: int

    @property
    def at(self) -> Place:
        """The place of the whole map."""
        return Place(self.source, self.start, end=self.end)

    def get(self, key: str) -> Node | None:
        """Return the value of a key, the last one of a duplicate key; None if the map does not have the key."""
        return next((entry.value for entry in reversed(self.entries) if entry.key.text == key), None)


class YamlEntry(NamedTuple):
    """A key and its value."""

    key: Scalar
    value: Node


Node = Scalar | Sequence | Mapping


class YamlFile(NamedTuple):
    """The content of a YAML file.

    documents: the root node of each document. An alias is the node of its anchor, with the anchor's place.
    aliases: the places of the aliases.
    python_tags: the places of the values with a tag that makes Python objects, such as !!python/tuple.
    problems: what is wrong with the file.
    readable: False if the file is not valid YAML, so that no program can read it.
    """

    source: SourceText
    documents: tuple[Node, ...]
    aliases: tuple[Place, ...]
    problems: tuple[Problem, ...]
    readable: bool = True
    python_tags: tuple[Place, ...] = ()

    @property
    def refused_tags(self) -> list[Problem]:
        """The problem of each of the first tags that make Python objects, for a file that is read by Python's safe
        reader: it rejects all of the file.
        """
        tags = [(place, place.span.text.split(maxsplit=1)[0]) for place in self.python_tags[:_MOST_TAGS]]
        return [
            Problem(ProblemKind.PYTHON_TAG, place, f"'{tag}' makes a Python object; {_REFUSED}", tag)
            for place, tag in tags
        ]


def read_yaml(source: SourceText, *, by_python: bool = False) -> YamlFile:
    """Return the tree of a file. If it is not valid YAML, there are no documents, and one problem.

    by_python: read the file with PyYAML's own parser, as rosparam does; it accepts fewer tabs than libyaml.
    """
    return _by_python(source) if by_python else _by_fastest(source)


def read_yaml_in(source: SourceText, start: int, text: bytes) -> YamlFile:
    """Return the tree of a text in a file, which begins at a byte offset. What is not YAML there has to be blanks."""
    return _read(_EventReader(source, SAFE_LOADER, text, start))


@once_per_object
def _by_python(source: SourceText) -> YamlFile:
    return _read(_EventReader(source, yaml.SafeLoader, source.data))


@once_per_object
def _by_fastest(source: SourceText) -> YamlFile:
    return _read(_EventReader(source, SAFE_LOADER, source.data))


def _read(reader: _EventReader) -> YamlFile:
    source = reader.source
    try:
        reader.read()
    except ReadError as error:
        return YamlFile(source, (), (), (error.problem,), readable=False)
    documents, aliases, problems = tuple(reader.documents), tuple(reader.aliases), tuple(reader.problems)
    return YamlFile(source, documents, aliases, problems, python_tags=tuple(reader.python_tags))


class _Open:
    """A list or map whose end has not been read yet."""

    __slots__ = ("anchor", "children", "depth", "is_map", "size", "start", "tag")

    def __init__(self, anchor: str | None, tag: str | None, start: int, *, is_map: bool) -> None:
        self.anchor, self.tag, self.start, self.is_map = anchor, tag, start, is_map
        self.children: list[Node] = []
        self.size, self.depth = 1, 1


class _Weight(NamedTuple):
    """The number of nodes in a node with its aliases expanded, and their depth."""

    size: int
    depth: int


_LEAF = _Weight(1, 0)


class _EventReader:
    def __init__(self, source: SourceText, loader: Any, data: bytes, base: int = 0) -> None:
        self.source = source
        self._loader = loader
        self._data, self._base = data, base
        self.documents: list[Node] = []
        self.aliases: list[Place] = []
        self.python_tags: list[Place] = []
        self.problems: list[Problem] = []
        self._open: list[_Open] = []
        self._anchors: dict[str, tuple[Node, _Weight]] = {}
        self._offset = self._ascii_offset
        self._size = 0

    def read(self) -> None:
        text = self._decoded()
        loader: Any = None
        try:
            loader = self._loader(text)
            while loader.check_event():
                self._take(loader.get_event())
        except yaml.reader.ReaderError:
            raise self._unprintable(text) from None
        except yaml.MarkedYAMLError as error:
            raise self._syntax(error) from None
        finally:
            if loader is not None:
                loader.dispose()

    # -- events ------------------------------------------------------------------------------------------------------

    def _take(self, event: Any) -> None:
        kind = type(event)
        if kind is yaml.ScalarEvent:
            start, end = self._offset(event.start_mark.index), self._offset(event.end_mark.index)
            self._add(
                Scalar(
                    text=event.value, style=event.style or "", tag=event.tag, source=self.source, start=start, end=end
                ),
                event.anchor,
                _LEAF,
            )
        elif kind is yaml.MappingStartEvent or kind is yaml.SequenceStartEvent:
            start = self._offset(event.start_mark.index)
            is_map = kind is yaml.MappingStartEvent
            self._open.append(_Open(event.anchor, event.tag, start, is_map=is_map))
            if len(self._open) > MOST_DEPTH:
                raise self._over(start, f"the YAML is nested more than {MOST_DEPTH} levels deep")
        elif kind is yaml.MappingEndEvent or kind is yaml.SequenceEndEvent:
            self._close(event)
        elif kind is yaml.AliasEvent:
            self._alias(event)
        elif kind is yaml.DocumentStartEvent:
            self._anchors = {}

    def _alias(self, event: Any) -> None:
        start = self._offset(event.start_mark.index)
        at = Place(self.source, start, end=self._offset(event.end_mark.index))
        if event.anchor not in self._anchors:
            within = any(opened.anchor == event.anchor for opened in self._open)
            what = "refers to itself" if within else f"has no anchor '&{event.anchor}' before it"
            raise ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"alias '*{event.anchor}' {what}"))
        self.aliases.append(at)
        node, weight = self._anchors[event.anchor]
        if len(self._open) + weight.depth > MOST_DEPTH:
            raise self._over(start, f"the YAML is nested more than {MOST_DEPTH} levels deep")
        self._add(node, None, weight)

    def _close(self, event: Any) -> None:
        opened = self._open.pop()
        end = self._offset(event.end_mark.index)
        if event.start_mark.index == event.end_mark.index:  # a block collection has no end token
            end = max((child.end for child in opened.children if child.start >= opened.start), default=opened.start)
        if opened.is_map:
            node: Node = Mapping(self._entries(opened), opened.tag, self.source, opened.start, end)
        else:
            node = Sequence(tuple(opened.children), opened.tag, self.source, opened.start, end)
        self._size -= opened.size - 1  # the children are counted already; _add counts this node
        self._add(node, opened.anchor, _Weight(opened.size, opened.depth))

    def _add(self, node: Node, anchor: str | None, weight: _Weight) -> None:
        if node.tag and node.tag.startswith(_PYTHON):
            self.python_tags.append(node.at)
        self._size += weight.size
        if self._size > MOST_NODES:
            raise self._over(node.start, f"the YAML expands to more than {MOST_NODES} values")
        if anchor:
            self._anchors[anchor] = node, weight
        if self._open:
            parent = self._open[-1]
            parent.children.append(node)
            parent.size += weight.size
            parent.depth = max(parent.depth, weight.depth + 1)
        else:
            self.documents.append(node)

    def _entries(self, opened: _Open) -> tuple[YamlEntry, ...]:
        keys, values = opened.children[::2], opened.children[1::2]
        seen: dict[str, YamlEntry] = {}
        entries = []
        for key, value in zip(keys, values, strict=True):
            if not isinstance(key, Scalar):
                message = "a list or map cannot be a parameter name. Quote text that contains braces or brackets"
                raise ReadError(Problem(ProblemKind.YAML_SYNTAX, key.at, message))
            entry = YamlEntry(key, value)
            if key.text in seen and key.text != "<<":
                self._duplicate(entry, seen[key.text])
            seen[key.text] = entry
            entries.append(entry)
        return tuple(entries)

    def _duplicate(self, entry: YamlEntry, first: YamlEntry) -> None:
        if len(self.problems) >= _MOST_DUPLICATES:
            return
        name, line = entry.key.text, self.source.position(first.key.start).line
        message = f"duplicate key '{name}', first in line {line}; the last value is used"
        kind = ProblemKind.YAML_DUPLICATE_KEY
        if isinstance(entry.value, Mapping) and isinstance(first.value, Mapping):
            kind = ProblemKind.YAML_DUPLICATE_MAP
            message = f"duplicate key '{name}', first in line {line}; Python's YAML reader uses only the last map"
        self.problems.append(Problem(kind, entry.key.at, message, name))

    # -- places ------------------------------------------------------------------------------------------------------

    def _decoded(self) -> str:
        data = self._data
        if data.startswith(BOM):
            data, self._base = data[len(BOM) :], self._base + len(BOM)
        try:
            text = data.decode("utf-8")
        except UnicodeDecodeError as error:
            at = Place(self.source, error.start + self._base, end=error.end + self._base)
            raise ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"the file is not UTF-8: {error.reason}")) from None
        if not text.isascii():
            self._text, self._known = text, (0, self._base)
            self._offset = self._other_offset
        return text

    def _ascii_offset(self, index: int) -> int:
        return int(index) + self._base

    def _other_offset(self, index: int) -> int:
        """The byte offset of a character index, counted from that of the last call: the indices are nearly sorted."""
        known, offset = self._known
        if index >= known:
            offset += len(self._text[known:index].encode())
        else:
            offset -= len(self._text[index:known].encode())
        self._known = index, offset
        return offset

    # -- problems ----------------------------------------------------------------------------------------------------

    def _over(self, start: int, message: str) -> ReadError:
        return ReadError(Problem(ProblemKind.BUDGET, Place(self.source, start, end=start + 1), message))

    def _unprintable(self, text: str) -> ReadError:
        found = re.search(_UNPRINTABLE, text)
        start = len(text[: found.start()].encode()) + self._base if found else 0
        what = f"the control character {found.group()!r}" if found else "a character"
        at = Place(self.source, start, end=start + (len(found.group().encode()) if found else 0))
        return ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"YAML does not allow {what}"))

    def _first_too_deep(self, end: int) -> int:
        """The place of the first bracket that is nested too deep, in a text that has many more before a place."""
        depth = int(self.source.data[self._base :].lstrip()[:1] not in (b"[", b"{"))  # a map or list around them
        for place in range(self._base, end):
            byte = self.source.data[place : place + 1]
            depth += (byte in b"[{") - (byte in b"]}")
            if depth > MOST_DEPTH:
                return place
        return end

    def _syntax(self, error: yaml.MarkedYAMLError) -> ReadError:
        from urdfctl.source.conflicts import merge_conflict

        conflict = merge_conflict(self.source)
        if conflict is not None:
            return ReadError(conflict)
        mark = error.problem_mark or error.context_mark
        if error.context_mark and (error.context or "").startswith(_OPENED):  # the place where it should end is unknown
            mark = error.context_mark
        start = min(self._offset(mark.index) if mark else self._base, len(self.source.data))
        for line in (self.source.position(start).line, self.source.position(start).line - 1):
            indent = re.match(_TAB_INDENT, self.source.line(line))
            if indent:
                at = Place(self.source, self.source.offset(line), end=self.source.offset(line) + indent.end())
                message = "this line is indented with a tab, which YAML does not allow. Use spaces"
                return ReadError(Problem(ProblemKind.YAML_TAB, at, message))
        if self.source.data[start : start + 1] == b"\t":
            message = "tab where YAML allows only spaces"
            return ReadError(Problem(ProblemKind.YAML_TAB, Place(self.source, start, end=start + 1), message))
        why = " ".join(part for part in (error.context, error.problem) if part) or "invalid YAML"
        if TOO_DEEP in why:
            return self._over(self._first_too_deep(start), f"the YAML is nested more than {MOST_DEPTH} levels deep")
        at = Place(self.source, start, end=min(start + 1, len(self.source.data)))
        return ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"the file is not valid YAML: {why}"))
