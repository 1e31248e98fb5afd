"""Suppressions: comments such as `urdfctl: ignore[UC201] reason`, which silence findings."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator

from urdfctl.source.span import Call, Place, SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_GUARD = rb"""<!--.*?(?:-->|\Z)|<(/?)xacro:(?:macro|if|unless)\b(?:[^<>"']|"[^"<]*"|'[^'<]*')*>"""
_COMMENT = rb"urdfctl:\s*ignore\[([A-Za-z0-9_, \t-]*)\]"


class Suppression(NamedTuple):
    """One comment that silences findings on its own line and on the next.

    span: the comment.
    codes: the silenced codes, or prefixes of codes.
    """

    span: SourceSpan
    codes: tuple[str, ...]
    line: int
    """The line on which the comment ends."""

    def silences(self, code: str, line: int) -> bool:
        """Return whether it silences a code on a line."""
        return line in (self.line, self.line + 1) and any(code.startswith(known) for known in self.codes)


def suppressions(source: SourceText) -> list[Suppression]:
    """Return the suppressions in one file, in order."""
    result: list[Suppression] = []
    if b"urdfctl:" not in source.data:
        return result
    comments = _xml_comments(source.data)
    for match in re.finditer(_COMMENT, source.data):
        codes = tuple(code.strip().upper() for code in match.group(1).decode("ascii").split(",") if code.strip())
        before = bisect_right(comments, (match.start(), 0))
        end = max(match.end(), comments[before - 1][1] if before else 0)
        result.append(Suppression(SourceSpan(source, match.start(), match.end()), codes, source.position(end).line))
    return result


def _xml_comments(data: bytes) -> list[tuple[int, int]]:
    """The start and end of each XML comment, as byte offsets."""
    comments = []
    start = data.find(b"<!--")
    while start >= 0:
        end = data.find(b"-->", start)
        if end < 0:
            break
        comments.append((start, end))
        start = data.find(b"<!--", end)
    return comments


class Suppressed:
    """The suppressions in all files of a robot, and which of them are used.

    all: the suppressions, in the order of the files.
    used: indices of those that silenced a finding.
    """

    def __init__(self, sources: list[SourceText]) -> None:
        self.all = [item for source in sources for item in suppressions(source)]
        self.used: set[int] = set()
        self._unused: dict[tuple[str, int, str], list[int]] = {}
        """By file, line, and code or prefix of codes: the indices of the suppressions, as long as they are not used."""
        for index, item in enumerate(self.all):
            for line in (item.line, item.line + 1):
                for code in item.codes:
                    self._unused.setdefault((item.span.file, line, code), []).append(index)

    def covers(self, code: str, place: Place) -> bool:
        """Return whether a finding is silenced at its own place, or at a macro's definition or call that led to it."""
        if not self.all:
            return False
        spans = [place.span]
        for call in place.call.chain() if place.call else ():
            spans += _spans_of(call)
        covered = [self._use(code, span) for span in spans]
        return any(covered)

    def _use(self, code: str, span: SourceSpan) -> bool:
        """Whether a suppression covers a code at a span. It counts as used from then on."""
        line = span.source.position(span.start).line
        keys = [(span.file, line, code[:length]) for length in range(1, len(code) + 1)]
        covering = [key for key in keys if key in self._unused]
        for key in covering:
            self.used.update(self._unused[key])
            self._unused[key] = []
        return bool(covering)


def _spans_of(call: Call) -> list[SourceSpan]:
    return [call.span, *([call.definition] if call.definition else [])]


class Reach:
    """Which parts of its files a tree contains.

    root: the root of the tree.
    """

    def __init__(self, root: Element) -> None:
        self._root = root
        self._starts: dict[str, list[int]] = {}
        """The offsets of the elements that come from a file, by its path."""
        self._guards: dict[SourceText, _Guards] = {}

    def contains(self, span: SourceSpan) -> bool:
        """Return whether the tree contains an element from the innermost macro or condition around a span.

        If not, the macro was not called, or the condition was false. True if there is no macro or condition.
        """
        source = span.source
        if source not in self._guards:
            self._guards[source] = _Guards(source.data)
        guard = self._guards[source].around(span.start)
        if guard is None:
            return True
        start, end = guard
        starts = self._starts_in(source.path)
        first = bisect_left(starts, start)
        return first < len(starts) and starts[first] < end

    def _starts_in(self, path: str) -> list[int]:
        if not self._starts:
            for element in self._root.walk():
                self._starts.setdefault(element.source.path, []).append(element.start)
            for starts in self._starts.values():
                starts.sort()
        return self._starts.get(path, [])


class _Guards:
    """The contents of the `<xacro:macro>`, `<xacro:if>` and `<xacro:unless>` in a file, as byte offsets."""

    def __init__(self, data: bytes) -> None:
        self._bounds = [0]
        self._inside: list[tuple[int, int] | None] = [None]
        """The innermost content from each bound to the next one."""
        opened: list[tuple[int, int] | None] = [None]
        for content in sorted(_contents_of_guards(data)):
            while (outer := opened[-1]) is not None and outer[1] <= content[0]:
                opened.pop()
                self._bound(outer[1], opened[-1])
            opened.append(content)
            self._bound(content[0], content)
        while (outer := opened.pop()) is not None:
            self._bound(outer[1], opened[-1])

    def _bound(self, offset: int, content: tuple[int, int] | None) -> None:
        self._bounds.append(offset)
        self._inside.append(content)

    def around(self, offset: int) -> tuple[int, int] | None:
        """Return the innermost content that contains an offset; None if none does."""
        return self._inside[bisect_right(self._bounds, offset) - 1]


def _contents_of_guards(data: bytes) -> Iterator[tuple[int, int]]:
    """Yield the start and end of the content of each guard."""
    opened: list[int] = []
    for tag in re.compile(_GUARD, re.DOTALL).finditer(data):
        if tag.group(1) is None or tag.group().endswith(b"/>"):
            continue
        if tag.group(1) == b"":
            opened.append(tag.end())
        elif opened:
            start = opened.pop()
            yield start, tag.start()
