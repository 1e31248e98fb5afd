"""Places in source files: the text of a file, a span in it, and the calls that led there."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping

from urdfctl.startup.records import NamedTuple

# patterns here and elsewhere are strings until their first use: compiling all of them would slow the start-up
BOM = b"\xef\xbb\xbf"
_LINE_END = rb"\r\n|\n|\r"
_TAG_NAME = rb"<([^\s/>]+)"
_ATTRIBUTE = rb"""\s*([^\s=/>"']+)\s*=\s*("[^"]*"|'[^']*')"""
_TAG_END = rb"\s*(/?>)"
_STRETCH = 1024
"""Bytes of a text that is not ASCII whose characters are counted at once."""


class Position(NamedTuple):
    """A line and a column, both starting at 1. The column counts code points, without a byte order mark."""

    line: int
    column: int


class SourceText:
    """The content of one file, as on disk.

    path: the path as it was read.
    data: the bytes.
    is_ascii: whether all bytes are ASCII, so that columns are byte offsets.
    """

    __slots__ = ("_lines", "_marks", "_tags", "data", "is_ascii", "path")

    def __init__(self, path: str, data: bytes) -> None:
        self.path = path
        self.data = data
        self.is_ascii = data.isascii()
        self._lines: list[int] | None = None
        self._marks: list[tuple[int, int]] | None = None
        self._tags: dict[int, StartTag | None] = {}

    @property
    def is_xacro(self) -> bool:
        """Whether the file is for xacro, by its name (`arm.xacro`, `arm.xacro.urdf`) or by xacro's namespace."""
        return ".xacro" in self.path.rpartition("/")[2] or b"xmlns:xacro" in self.data[:4096]

    def line_starts(self) -> list[int]:
        """Return the byte offset of the start of each line. LF, CRLF and CR end a line."""
        if self._lines is None:
            self._lines = [0] + [line_end.end() for line_end in re.finditer(_LINE_END, self.data)]
        return self._lines

    def position(self, offset: int) -> Position:
        """Return the line and column of a byte offset."""
        starts = self.line_starts()
        index = bisect_right(starts, offset) - 1
        if self.is_ascii:
            return Position(index + 1, min(offset, len(self.data)) - starts[index] + 1)
        start = starts[index]
        if index == 0 and self.data.startswith(BOM):
            start = min(len(BOM), offset)
        return Position(index + 1, self._characters(start, offset) + 1)

    def _characters(self, start: int, end: int) -> int:
        """The number of code points between two byte offsets. In a long line, they are not counted again each time."""
        if end - start > 2 * _STRETCH:
            marks = self._stretches()
            first, last = marks[start // _STRETCH + 1], marks[min(end, len(self.data)) // _STRETCH]
            return self._characters(start, first[0]) + last[1] - first[1] + self._characters(last[0], end)
        return len(self.data[start:end].decode("utf-8", "replace"))

    def _stretches(self) -> list[tuple[int, int]]:
        """The start of each stretch, and the number of code points before it."""
        if self._marks is None:
            self._marks = [(0, 0)]
            for nominal in range(_STRETCH, len(self.data) + 1, _STRETCH):
                start, count = self._marks[-1]
                end = self._character_start(nominal)
                self._marks.append((end, count + len(self.data[start:end].decode("utf-8", "replace"))))
        return self._marks

    def _character_start(self, offset: int) -> int:
        """The byte offset of the character that a byte belongs to."""
        start = offset
        while offset - start < 3 and self.data[start : start + 1] and self.data[start] & 0xC0 == 0x80:  # noqa: PLR2004 (UTF-8's bytes after the first)
            start -= 1
        return start

    def offset(self, line: int, column: int = 1) -> int:
        """Return the byte offset of a line and column, limited to the end of the file and of the line."""
        starts = self.line_starts()
        if line > len(starts):
            return len(self.data)
        text = self.line(line)
        offset = starts[line - 1] + len(text[: column - 1].encode("utf-8", "replace"))
        return offset + len(BOM) if line == 1 and self.data.startswith(BOM) else offset

    def line(self, number: int) -> str:
        """Return the text of a line without its line end and without a byte order mark; empty after the last line."""
        starts = self.line_starts()
        if not 0 < number <= len(starts):
            return ""
        start = len(BOM) if number == 1 and self.data.startswith(BOM) else starts[number - 1]
        end = starts[number] if number < len(starts) else len(self.data)
        return self.data[start:end].decode("utf-8", "replace").rstrip("\r\n")

    def excerpt(self, offset: int, most: int) -> tuple[str, int]:
        """Return the line that a byte offset is in, and 1; of a line with more than `most` characters, return `most` of
        them, about half of them before the offset, and the column of the first.
        """
        line, column = self.position(offset)
        starts = self.line_starts()
        end = starts[line] if line < len(starts) else len(self.data)
        widest = 4 * most
        if end - starts[line - 1] <= widest:
            text = self.line(line)
            start = max(0, column - 1 - most // 2) if len(text) > most else 0
            return text[start : start + most], start + 1
        near = self._character_start(max(starts[line - 1], offset - widest))
        before = self.data[near:offset].decode("utf-8", "replace").removeprefix("\ufeff")[-(most // 2) :]
        far = self._character_start(min(end, offset + widest)) if offset + widest < end else end
        after = self.data[offset:far].decode("utf-8", "replace").rstrip("\r\n")
        return (before + after)[:most], column - len(before)

    def start_tag(self, offset: int) -> StartTag | None:
        """Return the start tag at a byte offset; None if there is none, as for elements from an entity."""
        if offset not in self._tags:
            self._tags[offset] = _read_start_tag(self.data, offset)
        return self._tags[offset]


class StartTag(NamedTuple):
    """A start tag.

    name: the qualified name.
    start, end: byte offsets of `<` and after `>`.
    attributes: byte offsets of the start and end of each attribute's value, without its quotes.
    self_closed: whether the tag ends in `/>`.
    """

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
    while attribute := re.compile(_ATTRIBUTE).match(data, position):
        attributes[attribute.group(1).decode("utf-8", "replace")] = (attribute.start(2) + 1, attribute.end(2) - 1)
        position = attribute.end()
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
        """The path of the file, as it was read."""
        return self.source.path

    @property
    def text(self) -> str:
        """The text of the span."""
        return self.source.data[self.start : self.end].decode("utf-8", "replace")


class Call:
    """One step in the expansion that produced an element: a macro call, an include or an inserted block.

    A step's parent is the step that produced the text in which the call is *written*. So the parent of a call inside a
    block argument comes from the file that contains the block.

    kind: `macro`, `include` or `block`.
    name: name of the macro or of the included file; for a block, of the macro that it was passed to.
    source, offset: byte offset of the start tag of the call, in its file.
    parent: the step that produced the call; None if it is written in the main file.
    """

    __slots__ = ("definition", "kind", "name", "offset", "parent", "source")

    def __init__(self, kind: str, name: str, source: SourceText, offset: int, parent: Call | None) -> None:
        self.kind = kind
        self.name = name
        self.source = source
        self.offset = offset
        self.parent = parent
        self.definition: SourceSpan | None = None
        """The start tag of the called macro; None for other steps."""

    def chain(self) -> Iterator[Call]:
        """Yield this step and the steps that led to it, innermost first."""
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
    """The place of an element, an attribute or a text in the user's source, and the calls that led to it.

    source: the file.
    start: byte offset of the first byte.
    call: the innermost call that produced the element; None if it was written where it is.
    end: byte offset after the last byte; None for an element, whose start tag is the place.
    close: byte offset of the element's end tag.
    attributes: attributes that are written in another element, with that element's source and byte offset.
    """

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
        """The start tag of an element, the value of an attribute, or the characters of a text."""
        if self._end is not None:
            return SourceSpan(self.source, self.start, self._end)
        tag = self.source.start_tag(self.start)
        return SourceSpan(self.source, self.start, tag.end if tag else self.start)

    def __getitem__(self, attribute: str) -> Place:
        """Return the place of an attribute's value; the element's own place if the attribute is not in the source."""
        if self._attributes and attribute in self._attributes:
            source, offset = self._attributes[attribute]
            return Place(source, offset, self.call)
        tag = self.source.start_tag(self.start)
        if tag is None or attribute not in tag.attributes:
            return self
        start, end = tag.attributes[attribute]
        return Place(self.source, start, self.call, end=end)

    def is_same(self, other: Place) -> bool:
        """Return whether another place is the same part of the same text, and the same calls led to it."""
        own = self.source, self.call, self.start, self._end, self._close, self._attributes
        return own == (other.source, other.call, other.start, other._end, other._close, other._attributes)

    @property
    def closing(self) -> int | None:
        """The byte offset of the element's end tag; None if it has none or it is unknown."""
        return self._close

    @property
    def content(self) -> Place:
        """The content between the start tag and the end tag, without surrounding blanks; the start tag if empty."""
        tag = self.source.start_tag(self.start)
        if tag is None or tag.self_closed or self._close is None or self._close <= tag.end:
            return self
        inside = self.source.data[tag.end : self._close]
        if not inside.strip():
            return self
        start = tag.end + len(inside) - len(inside.lstrip())
        return Place(self.source, start, self.call, end=start + len(inside.strip()))

    def part(self, text: str) -> Place:
        """Return the place of the first occurrence of a text in this place; the whole place if it is not found."""
        span = self.span
        before, found, _ = span.text.partition(text)
        if not found:
            return self
        start = span.start + len(before.encode())
        return Place(span.source, start, self.call, end=start + len(text.encode()))

    def word(self, word: str) -> Place:
        """Return the place of a blank-separated word in this place; the whole place if the word is not found."""
        span = self.span
        match = re.search(rf"(?<!\S){re.escape(word)}(?!\S)", span.text)
        if match is None:
            return self
        start = span.start + len(span.text[: match.start()].encode())
        return Place(span.source, start, self.call, end=start + len(word.encode()))

    def words(self, words: Iterable[str]) -> Iterator[Place]:
        """Yield the place of each blank-separated word in this place, as `word` finds it. If there are several, it is
        the n-th one for a word that comes for the n-th time.
        """
        span = self.span
        text = span.text
        places: dict[str, list[tuple[int, int]]] = {}
        counted, offset = 0, span.start
        for found in re.finditer(r"\S+", text):
            offset += len(text[counted : found.start()].encode())
            counted = found.start()
            places.setdefault(found.group(), []).append((counted, offset))
        for known in places.values():
            known.reverse()
        for word in words:
            known = places.get(word.split(None, 1)[0] if word.split() else word, [])
            index, start = known[-1] if known else (0, 0)
            if len(known) > 1:
                known.pop()
            if known and text.startswith(word, index):  # a quoted word has blanks
                yield Place(span.source, start, self.call, end=start + len(word.encode()))
            else:
                yield self
