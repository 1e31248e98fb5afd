"""Reads YAML into a located tree: every key, value and element knows its bytes. Values stay text; `yaml_types` types
them as their reader does.

The tree is made from the parser's stream of events, without recursion and within limits: a file of brackets crashes
the C library's own composer, and a few aliases of aliases stand for more than any memory holds.
"""

from __future__ import annotations

import re

from urdfctl.hints import Any
from urdfctl.record import NamedTuple
from urdfctl.source.problem import Problem, ProblemKind, ReadError
from urdfctl.source.pyyaml import yaml
from urdfctl.source.span import BOM, Place, SourceText

MOST_DEPTH = 64
MOST_NODES = 200_000
_MOST_DUPLICATES = 20
_UNPRINTABLE = "[^\t\n\r\x20-\x7e\x85\xa0-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"
_TAB_INDENT = r" *\t[ \t]*(?=[^\s#])"
_OPENED = ("while parsing a flow", "while scanning a quoted")
_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class Scalar(NamedTuple):
    """A text; `style` is one of `'`, `"`, `|`, `>`, and empty for a plain one."""

    text: str
    style: str
    tag: str | None
    source: SourceText
    start: int
    end: int

    @property
    def at(self) -> Place:
        """Where it stands, with its quotes."""
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
        """From its first to its last byte."""
        return Place(self.source, self.start, end=self.end)


class Mapping(NamedTuple):
    """A map: its entries in order, with keys that are given twice."""

    entries: tuple[Entry, ...]
    tag: str | None
    source: SourceText
    start: int
    end: int

    @property
    def at(self) -> Place:
        """From its first to its last byte."""
        return Place(self.source, self.start, end=self.end)

    def get(self, key: str) -> Node | None:
        """The value of a key; of the last one where it is given twice."""
        return next((entry.value for entry in reversed(self.entries) if entry.key.text == key), None)


class Entry(NamedTuple):
    """A key with its value."""

    key: Scalar
    value: Node


Node = Scalar | Sequence | Mapping


class YamlFile(NamedTuple):
    """What a file holds: its documents, where aliases stand in it, and what is wrong with it. An alias is what it
    stands for: the same node, at the place of its anchor. With `readable` False no reader gets anything out of it."""

    source: SourceText
    documents: tuple[Node, ...]
    aliases: tuple[Place, ...]
    problems: tuple[Problem, ...]
    readable: bool = True


def read_yaml(source: SourceText, *, by_python: bool = False) -> YamlFile:
    """The tree of a file; without documents where it is no YAML, and then a problem tells why. Read `by_python`, as
    rosparam does, a file may hold fewer tabs than libyaml takes."""
    reader = _Reader(source, yaml.SafeLoader if by_python else _LOADER)
    try:
        reader.read()
    except ReadError as error:
        return YamlFile(source, (), (), (error.problem,), readable=False)
    return YamlFile(source, tuple(reader.documents), tuple(reader.aliases), tuple(reader.problems))


class _Open:
    """A list or map whose end is not read yet."""

    __slots__ = ("anchor", "children", "depth", "is_map", "size", "start", "tag")

    def __init__(self, anchor: str | None, tag: str | None, start: int, *, is_map: bool) -> None:
        self.anchor, self.tag, self.start, self.is_map = anchor, tag, start, is_map
        self.children: list[Node] = []
        self.size, self.depth = 1, 1


class _Weight(NamedTuple):
    """How many nodes a node stands for with its aliases written out, and how deep they are nested."""

    size: int
    depth: int


_LEAF = _Weight(1, 0)


class _Reader:
    def __init__(self, source: SourceText, loader: Any) -> None:
        self.source = source
        self._loader = loader
        self.documents: list[Node] = []
        self.aliases: list[Place] = []
        self.problems: list[Problem] = []
        self._open: list[_Open] = []
        self._anchors: dict[str, tuple[Node, _Weight]] = {}
        self._offset = self._ascii_offset
        self._base = self._size = 0

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
            self._add(Scalar(event.value, event.style or "", event.tag, self.source, start, end), event.anchor, _LEAF)
        elif kind is yaml.MappingStartEvent or kind is yaml.SequenceStartEvent:
            start = self._offset(event.start_mark.index)
            is_map = kind is yaml.MappingStartEvent
            self._open.append(_Open(event.anchor, event.tag, start, is_map=is_map))
            if len(self._open) > MOST_DEPTH:
                raise self._over(start, f"the YAML is nested more than {MOST_DEPTH} deep")
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
            what = "stands in what it stands for" if within else "is defined nowhere before"
            raise ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"the alias '*{event.anchor}' {what}"))
        self.aliases.append(at)
        node, weight = self._anchors[event.anchor]
        if len(self._open) + weight.depth > MOST_DEPTH:
            raise self._over(start, f"the YAML is nested more than {MOST_DEPTH} deep")
        self._add(node, None, weight)

    def _close(self, event: Any) -> None:
        opened = self._open.pop()
        end = self._offset(event.end_mark.index)
        if event.start_mark.index == event.end_mark.index:  # a block has no end of its own
            end = max((child.end for child in opened.children if child.start >= opened.start), default=opened.start)
        if opened.is_map:
            node: Node = Mapping(self._entries(opened), opened.tag, self.source, opened.start, end)
        else:
            node = Sequence(tuple(opened.children), opened.tag, self.source, opened.start, end)
        self._size -= opened.size - 1  # the parts are counted; the whole adds itself
        self._add(node, opened.anchor, _Weight(opened.size, opened.depth))

    def _add(self, node: Node, anchor: str | None, weight: _Weight) -> None:
        self._size += weight.size
        if self._size > MOST_NODES:
            raise self._over(node.start, f"the YAML stands for more than {MOST_NODES} values")
        if anchor:
            self._anchors[anchor] = node, weight
        if self._open:
            around = self._open[-1]
            around.children.append(node)
            around.size += weight.size
            around.depth = max(around.depth, weight.depth + 1)
        else:
            self.documents.append(node)

    def _entries(self, opened: _Open) -> tuple[Entry, ...]:
        keys, values = opened.children[::2], opened.children[1::2]
        seen: dict[str, Entry] = {}
        entries = []
        for key, value in zip(keys, values, strict=True):
            if not isinstance(key, Scalar):
                message = "a list or a map is no name of a parameter: quote what is a text with braces or brackets"
                raise ReadError(Problem(ProblemKind.YAML_SYNTAX, key.at, message))
            entry = Entry(key, value)
            if key.text in seen and key.text != "<<":
                self._duplicate(entry, seen[key.text])
            seen[key.text] = entry
            entries.append(entry)
        return tuple(entries)

    def _duplicate(self, entry: Entry, first: Entry) -> None:
        if len(self.problems) >= _MOST_DUPLICATES:
            return
        name, line = entry.key.text, self.source.position(first.key.start).line
        message = f"'{name}' is given twice in this map, first in line {line}; the last one counts"
        kind = ProblemKind.YAML_DUPLICATE_KEY
        if isinstance(entry.value, Mapping) and isinstance(first.value, Mapping):
            kind = ProblemKind.YAML_DUPLICATE_MAP
            message = (
                f"'{name}' is given twice, first in line {line}: what reads YAML with Python takes the last one only"
            )
        self.problems.append(Problem(kind, entry.key.at, message, name))

    # -- places ------------------------------------------------------------------------------------------------------

    def _decoded(self) -> str:
        data = self.source.data
        self._base = len(BOM) if data.startswith(BOM) else 0
        try:
            text = data[self._base :].decode("utf-8")
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
        """The offset of a character, counted from the last one that was asked for: they come nearly in order."""
        known, offset = self._known
        if index >= known:
            offset += len(self._text[known:index].encode())
        else:
            offset -= len(self._text[index:known].encode())
        self._known = index, offset
        return offset

    # -- faults ------------------------------------------------------------------------------------------------------

    def _over(self, start: int, message: str) -> ReadError:
        return ReadError(Problem(ProblemKind.BUDGET, Place(self.source, start, end=start + 1), message))

    def _unprintable(self, text: str) -> ReadError:
        found = re.search(_UNPRINTABLE, text)
        start = len(text[: found.start()].encode()) + self._base if found else 0
        what = f"the control character {found.group()!r}" if found else "a character"
        at = Place(self.source, start, end=start + (len(found.group().encode()) if found else 0))
        return ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"YAML does not allow {what}"))

    def _syntax(self, error: yaml.MarkedYAMLError) -> ReadError:
        mark = error.problem_mark or error.context_mark
        if error.context_mark and (error.context or "").startswith(_OPENED):  # where it should close is anybody's guess
            mark = error.context_mark
        start = min(self._offset(mark.index) if mark else 0, len(self.source.data))
        for line in (self.source.position(start).line, self.source.position(start).line - 1):
            indent = re.match(_TAB_INDENT, self.source.line(line))
            if indent:
                at = Place(self.source, self.source.offset(line), end=self.source.offset(line) + indent.end())
                message = "this line is indented with a tab, which YAML does not allow: use spaces"
                return ReadError(Problem(ProblemKind.YAML_TAB, at, message))
        if self.source.data[start : start + 1] == b"\t":
            message = "a tab stands where YAML allows spaces only"
            return ReadError(Problem(ProblemKind.YAML_TAB, Place(self.source, start, end=start + 1), message))
        why = " ".join(part for part in (error.context, error.problem) if part) or "no YAML"
        at = Place(self.source, start, end=min(start + 1, len(self.source.data)))
        return ReadError(Problem(ProblemKind.YAML_SYNTAX, at, f"the file is not YAML: {why}"))
