"""`urdfctl: ignore[UC201] why` in a comment: which findings the user has decided to live with."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator

from urdfctl.record import NamedTuple
from urdfctl.source.dom import Element
from urdfctl.source.span import Call, Place, SourceSpan, SourceText

_GUARD = rb"""<!--.*?(?:-->|\Z)|<(/?)xacro:(?:macro|if|unless)\b(?:[^<>"']|"[^"<]*"|'[^'<]*')*>"""
_COMMENT = rb"urdfctl:\s*ignore\[([A-Za-z0-9_, \t-]*)\]"


class Suppression(NamedTuple):
    """One comment: the codes (or prefixes of codes) that it silences on its own line and on the next."""

    span: SourceSpan
    codes: tuple[str, ...]
    line: int
    """The line on which the comment ends."""

    def silences(self, code: str, line: int) -> bool:
        """Whether it speaks of a code on a line."""
        return line in (self.line, self.line + 1) and any(code.startswith(known) for known in self.codes)


def suppressions(source: SourceText) -> list[Suppression]:
    """The suppressing comments of one file."""
    found: list[Suppression] = []
    if b"urdfctl:" not in source.data:
        return found
    comments = _xml_comments(source.data)
    for match in re.finditer(_COMMENT, source.data):
        codes = tuple(code.strip().upper() for code in match.group(1).decode("ascii").split(",") if code.strip())
        before = bisect_right(comments, (match.start(), 0))
        end = max(match.end(), comments[before - 1][1] if before else 0)
        found.append(Suppression(SourceSpan(source, match.start(), match.end()), codes, source.position(end).line))
    return found


def _xml_comments(data: bytes) -> list[tuple[int, int]]:
    """Where each XML comment begins and where it ends."""
    found = []
    start = data.find(b"<!--")
    while start >= 0:
        end = data.find(b"-->", start)
        if end < 0:
            break
        found.append((start, end))
        start = data.find(b"<!--", end)
    return found


class Suppressed:
    """Asks the comments of all files of a robot, and remembers which of them had anything to silence."""

    def __init__(self, sources: list[SourceText]) -> None:
        self.all = [item for source in sources for item in suppressions(source)]
        self.used: set[int] = set()
        self._by_file: dict[str, list[int]] = {}
        for index, item in enumerate(self.all):
            self._by_file.setdefault(item.span.file, []).append(index)

    def covers(self, code: str, place: Place) -> bool:
        """Whether a finding is silenced where it stands, at a macro's definition or at a call that led to it."""
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
    """Whether a tree holds anything of the innermost macro or condition that a span lies in: else the macro was not
    called, or the condition did not hold."""
    around = _guard_around(span)
    if around is None:
        return True
    return any(
        element.source.path == span.file and around[0] <= element.start < around[1] for element in _elements(root)
    )


def _guard_around(span: SourceSpan) -> tuple[int, int] | None:
    """Where the innermost `<xacro:macro>`, `<xacro:if>` or `<xacro:unless>` around a span begins and ends."""
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
