"""Where something stands: the text of a file, a span in it, and the calls that led there."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping

from urdfctl.record import NamedTuple

# patterns here and elsewhere stay texts until their first use: compiling them all would show in the start-up
BOM = b"\xef\xbb\xbf"
_LINE_END = rb"\r\n|\n|\r"
_TAG_NAME = rb"<([^\s/>]+)"
_ATTRIBUTE = rb"""\s*([^\s=/>"']+)\s*=\s*("[^"]*"|'[^']*')"""
_TAG_END = rb"\s*(/?>)"


class Position(NamedTuple):
    """A line and a column, both from 1; the column counts code points, a byte order mark is not counted."""

    line: int
    column: int


class SourceText:
    """The bytes of one file, as they stand on disk."""

    __slots__ = ("_lines", "_tags", "data", "is_ascii", "path")

    def __init__(self, path: str, data: bytes) -> None:
        self.path = path
        self.data = data
        self.is_ascii = data.isascii()
        self._lines: list[int] | None = None
        self._tags: dict[int, StartTag | None] = {}

    @property
    def is_xacro(self) -> bool:
        """Whether a file is meant for xacro: by its name (`arm.xacro`, `arm.xacro.urdf`), or by xacro's namespace."""
        return ".xacro" in self.path.rpartition("/")[2] or b"xmlns:xacro" in self.data[:4096]

    def line_starts(self) -> list[int]:
        """The byte offset at which each line begins; LF, CRLF and CR end a line."""
        if self._lines is None:
            self._lines = [0] + [found.end() for found in re.finditer(_LINE_END, self.data)]
        return self._lines

    def position(self, offset: int) -> Position:
        """The line and column of a byte offset."""
        starts = self.line_starts()
        index = bisect_right(starts, offset) - 1
        if self.is_ascii:
            return Position(index + 1, min(offset, len(self.data)) - starts[index] + 1)
        before = self.data[starts[index] : offset]
        if index == 0 and before.startswith(BOM):
            before = before[len(BOM) :]
        return Position(index + 1, len(before.decode("utf-8", "replace")) + 1)

    def offset(self, line: int, column: int = 1) -> int:
        """The byte offset of a line and column, cut to what the file holds."""
        starts = self.line_starts()
        if line > len(starts):
            return len(self.data)
        text = self.line(line)
        offset = starts[line - 1] + len(text[: column - 1].encode("utf-8", "replace"))
        return offset + len(BOM) if line == 1 and self.data.startswith(BOM) else offset

    def line(self, number: int) -> str:
        """The text of a line, without its end and without a byte order mark; empty past the last one."""
        starts = self.line_starts()
        if not 0 < number <= len(starts):
            return ""
        start = len(BOM) if number == 1 and self.data.startswith(BOM) else starts[number - 1]
        end = starts[number] if number < len(starts) else len(self.data)
        return self.data[start:end].decode("utf-8", "replace").rstrip("\r\n")

    def start_tag(self, offset: int) -> StartTag | None:
        """The start tag at an offset, or None where none stands there (text that an entity brought in)."""
        if offset not in self._tags:
            self._tags[offset] = _read_start_tag(self.data, offset)
        return self._tags[offset]


class StartTag(NamedTuple):
    """The byte offsets of a start tag, and of the values of its attributes (without their quotes)."""

    name: str
    start: int
    end: int
    attributes: Mapping[str, tuple[int, int]]
    self_closed: bool


def _read_start_tag(data: bytes, offset: int) -> StartTag | None:
    name = re.compile(_TAG_NAME).match(data, offset)
    if not name:
        return None
    attributes: dict[str, tuple[int, int]] = {}
    position = name.end()
    while found := re.compile(_ATTRIBUTE).match(data, position):
        attributes[found.group(1).decode("utf-8", "replace")] = (found.start(2) + 1, found.end(2) - 1)
        position = found.end()
    end = re.compile(_TAG_END).match(data, position)
    stop = end.end() if end else position
    return StartTag(
        name.group(1).decode("utf-8", "replace"), offset, stop, attributes, bool(end and end.group(1) == b"/>")
    )


class SourceSpan(NamedTuple):
    """A half-open range of byte offsets in one file."""

    source: SourceText
    start: int
    end: int

    @property
    def file(self) -> str:
        """The file's path, as it was read."""
        return self.source.path

    @property
    def text(self) -> str:
        """What the span cuts out of the file."""
        return self.source.data[self.start : self.end].decode("utf-8", "replace")


class Call:
    """One step of the way by which a text came to where it is: a macro's call, an include, an inserted block.

    Steps link by who *wrote* the text: a call inside a block argument belongs to the file that holds the block.
    """

    __slots__ = ("definition", "kind", "name", "offset", "parent", "source")

    def __init__(self, kind: str, name: str, source: SourceText, offset: int, parent: Call | None) -> None:
        self.kind = kind
        self.name = name
        self.source = source
        self.offset = offset
        self.parent = parent
        self.definition: SourceSpan | None = None
        """The start tag of the macro that is called, or nothing for other steps."""

    def chain(self) -> Iterator[Call]:
        """The step itself and those that led to it, innermost first."""
        step: Call | None = self
        while step is not None:
            yield step
            step = step.parent

    @property
    def span(self) -> SourceSpan:
        """The start tag of the call."""
        tag = self.source.start_tag(self.offset)
        return SourceSpan(self.source, self.offset, tag.end if tag else self.offset)

    @property
    def at(self) -> Place:
        """The place of the call, and the calls that led to it."""
        return Place(self.source, self.offset, self.parent)


class Place:
    """Where an element, an attribute or a text stands in the source the user wrote, and the calls that led to it."""

    __slots__ = ("_attributes", "_close", "_end", "call", "source", "start")

    def __init__(
        self,
        source: SourceText,
        start: int,
        call: Call | None = None,
        *,
        end: int | None = None,
        close: int | None = None,
        attributes: Mapping[str, tuple[SourceText, int]] | None = None,
    ) -> None:
        self.source = source
        self.start = start
        self.call = call
        self._end = end
        self._close = close
        self._attributes = attributes

    @property
    def span(self) -> SourceSpan:
        """The start tag of an element; the value of an attribute; the characters of a text."""
        if self._end is not None:
            return SourceSpan(self.source, self.start, self._end)
        tag = self.source.start_tag(self.start)
        return SourceSpan(self.source, self.start, tag.end if tag else self.start)

    def __getitem__(self, attribute: str) -> Place:
        """The place of an attribute's value; the element's own where the source does not write that attribute."""
        if self._attributes and attribute in self._attributes:
            source, offset = self._attributes[attribute]
            return Place(source, offset, self.call)
        tag = self.source.start_tag(self.start)
        if tag is None or attribute not in tag.attributes:
            return self
        start, end = tag.attributes[attribute]
        return Place(self.source, start, self.call, end=end)

    @property
    def closing(self) -> int | None:
        """The offset of the element's end tag; None where it closes itself or its end is not known."""
        return self._close

    @property
    def content(self) -> Place:
        """What stands between the two tags, without the blanks around it; the start tag itself where nothing does."""
        tag = self.source.start_tag(self.start)
        if tag is None or tag.self_closed or self._close is None or self._close <= tag.end:
            return self
        inside = self.source.data[tag.end : self._close]
        if not inside.strip():
            return self
        start = tag.end + len(inside) - len(inside.lstrip())
        return Place(self.source, start, self.call, end=start + len(inside.strip()))

    def word(self, word: str) -> Place:
        """Where a word, with blanks around it, stands in this place; the whole place where it is not written so."""
        span = self.span
        found = re.search(rf"(?<!\S){re.escape(word)}(?!\S)", span.text)
        if found is None:
            return self
        start = span.start + len(span.text[: found.start()].encode())
        return Place(span.source, start, self.call, end=start + len(word.encode()))
