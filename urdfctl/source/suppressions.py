"""Suppressions: comments such as `urdfctl: ignore[UC201] reason`, which silence findings."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator

from urdfctl.source.dom import Element
from urdfctl.source.span import Call, Place, SourceSpan, SourceText
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
        self._by_file: dict[str, list[int]] = {}
        for index, item in enumerate(self.all):
            self._by_file.setdefault(item.span.file, []).append(index)

    def covers(self, code: str, place: Place) -> bool:
        """Return whether a finding is silenced at its own place, or at a macro's definition or call that led to it."""
        if not self.all:
            return False
        spans = [place.span]
        for call in place.call.chain() if place.call else ():
            spans += _spans_of(call)
        covering = {index for span in spans for index in self._covering(code, span)}
        self.used |= covering
        return bool(covering)

    def _covering(self, code: str, span: SourceSpan) -> list[int]:
        indices = self._by_file.get(span.file)
        if not indices:
            return []
        line = span.source.position(span.start).line
        return [index for index in indices if self.all[index].silences(code, line)]


def _spans_of(call: Call) -> list[SourceSpan]:
    return [call.span, *([call.definition] if call.definition else [])]


def is_reached(span: SourceSpan, root: Element) -> bool:
    """Return whether a tree contains an element from the innermost macro or condition around a span.

    If not, the macro was not called, or the condition was false. True if there is no macro or condition.
    """
    guard = _guard_around(span)
    if guard is None:
        return True
    start, end = guard
    return any(element.source.path == span.file and start <= element.start < end for element in _elements(root))


def _guard_around(span: SourceSpan) -> tuple[int, int] | None:
    """The content of the innermost `<xacro:macro>`, `<xacro:if>` or `<xacro:unless>` around a span, as byte offsets."""
    opened: list[int] = []
    for tag in re.compile(_GUARD, re.DOTALL).finditer(span.source.data):
        if tag.group(1) is None or tag.group().endswith(b"/>"):
            continue
        if tag.group(1) == b"":
            opened.append(tag.end())
        elif opened:
            start = opened.pop()
            if start <= span.start < tag.start():
                return start, tag.start()
    return None


def _elements(root: Element) -> Iterator[Element]:
    yield root
    for child in root.elements():
        yield from _elements(child)
