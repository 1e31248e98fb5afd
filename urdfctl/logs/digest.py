"""Summarize a log: each known message once, with its count and first line, and the unknown errors."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfctl.catalog.log_messages import KINDS, LogMessage
from urdfctl.logs.index import Hit, Spelling, found_among, index
from urdfctl.logs.partial import partial
from urdfctl.logs.pattern import single_blanks
from urdfctl.startup.records import NamedTuple

_MOST_VALUES = 100
"""Distinct sets of values kept per message."""
_MOST_UNKNOWN = 100
"""Distinct unknown errors kept."""
_MOST_SEARCHES = 400
"""Slow searches for partial messages, one per distinct line; numbers in a line do not count."""
_MOST_WRAPPED = 6
"""Lines over which a message may be wrapped."""
_MOST_PREFIXES = 12
"""Prefixes removed from a line."""
_MOST_CANDIDATES = 3
"""Messages reported for a truncated pasted line; with more candidates, the line is unknown."""
_STRAIGHT = str.maketrans("‘’“”", "''\"\"")  # noqa: RUF001 (web pages replace straight quotes)
_LEVELS = r"ERROR|Error|error|Err|FATAL|Fatal|critical|WARN|WARNING|Warning|warning|Wrn"
_SUSPICIOUS = re.compile(rf"\[\s*(?:{_LEVELS})\s*\]|\b(?:{_LEVELS})\b\s*:|\b[Ee]xception\b|what\(\):")
_NOT_SUSPICIOUS = re.compile(r"\[\s*(?:INFO|DEBUG|Msg|Dbg|info|debug)\s*\]")
_ERROR = re.compile(r"\[\s*(?:ERROR|error|Err|FATAL|critical)\s*\]|\b(?:ERROR|Error|FATAL)\b\s*:|what\(\):")
_PROCESS = re.compile(r"\[[\w.-]+ *-\d+\] ?")
_PREFIX = re.compile(
    rf"""(?: \[[\w.-]+\ *-\d+\]                                         # [controller_manager-1]
          | \[\s*(?:{_LEVELS}|INFO|DEBUG|Msg|Dbg|info|debug)\s*\]     # [ERROR], [Err]
          | \[[\d.,:/ -]+\] | \[WallTime:[^\]]*\]                    # [1623.45, 0.2]
          | \[[\w/.-]+\]: | \[[\w./-]+:\d+\]                         # [controller_manager]:, [file.cc:12]
          | \(?\d{{4}}-\d\d-\d\d[T ][\d:.,]+Z?\)? | : )\s*""",
    re.VERBOSE,
)


class Known(NamedTuple):
    """A known message in a log.

    line: the number of its first line. times: how often it occurs. text: the text of its first occurrence.
    values: the values by name, once per distinct set.
    """

    message: LogMessage
    line: int
    times: int
    text: str
    values: tuple[dict[str, str], ...]


class Unknown(NamedTuple):
    """An unknown text; nearest: the most similar known message, None if none is similar."""

    line: int
    times: int
    text: str
    nearest: Spelling | None


class Digest(NamedTuple):
    """The known messages (most urgent first, then by line) and the unknown errors. lines: number of lines read."""

    lines: int
    known: tuple[Known, ...]
    unknown: tuple[Unknown, ...]


def digest(lines: Iterable[str], *, pasted: bool) -> Digest:
    """Return the messages in the lines.

    pasted: search every line for partial messages; otherwise only lines that look like errors.
    """
    reader = _Reader(pasted=pasted)
    for line in lines:
        reader.read(line)
    return reader.finished()


class _Wrapped(NamedTuple):
    """A line that may end in the middle of a message, which continues in the next line."""

    number: int
    text: str
    hits: tuple[Hit, ...]
    is_error: bool
    lines: int = 1


class _Reader:
    """Read lines one by one and collect the messages."""

    def __init__(self, *, pasted: bool) -> None:
        self._index = index()
        self._partial = partial()
        self._pasted = pasted
        self._number = 0
        self._known: dict[str, Known] = {}
        self._unknown: dict[str, Unknown] = {}
        self._searched: dict[str, tuple[Hit, ...]] = {}
        self._wrapped: _Wrapped | None = None

    def read(self, line: str) -> None:
        """Read the next line."""
        self._number += 1
        if self._pasted and not line.isascii():
            line = line.translate(_STRAIGHT)
        hits = self._index.hits(line)
        wrapped, self._wrapped = self._wrapped, None
        if wrapped and not hits and self._continues(wrapped, line):
            return
        if wrapped:
            self._record(wrapped)
        for hit in hits:
            self._keep(hit, self._number, line)
        if not hits and (self._pasted or _is_suspicious(line)) and line.strip():
            self._search_partial(line)

    def finished(self) -> Digest:
        """Return the collected messages."""
        if self._wrapped:
            self._record(self._wrapped)
        known = sorted(self._known.values(), key=lambda entry: (KINDS.index(entry.message.kind), entry.line))
        return Digest(self._number, tuple(known), tuple(self._unknown.values()))

    def _search_partial(self, line: str) -> None:
        """Search for a partial message in a line without a complete one."""
        text = plain(line)
        shape = re.sub(r"\d+", "0", text)
        if shape not in self._searched:
            if len(self._searched) >= _MOST_SEARCHES:
                return
            self._searched[shape] = tuple(self._partial.cut(text))
        is_error = self._pasted or _ERROR.search(line) is not None
        cut = _Wrapped(self._number, text, self._searched[shape], is_error)
        if cut.hits:
            self._wrapped = cut
        else:
            self._record(cut)

    def _continues(self, wrapped: _Wrapped, line: str) -> bool:
        """Whether a line continues the message in which the line before ends."""
        text = single_blanks(_PROCESS.sub("", line, count=1))
        spellings = [Spelling(hit.message, hit.pattern) for hit in wrapped.hits]
        for joined in (f"{wrapped.text} {text}", wrapped.text + text):
            hits = found_among(spellings, joined)
            if hits:
                self._keep(hits[0], wrapped.number, joined)
                return True
        for joined in (f"{wrapped.text} {text}", wrapped.text + text):
            longer = tuple(self._partial.cut(joined)) if wrapped.lines < _MOST_WRAPPED else ()
            if longer and {hit.message.id for hit in longer} <= {hit.message.id for hit in wrapped.hits}:
                self._wrapped = wrapped._replace(text=joined, hits=longer, lines=wrapped.lines + 1)
                return True
        return False

    def _record(self, cut: _Wrapped) -> None:
        """Record a line that does not continue: a truncated message, or an unknown one."""
        if cut.hits and len(cut.hits) <= (_MOST_CANDIDATES if self._pasted else 1):
            for hit in cut.hits:
                self._keep(hit, cut.number, cut.text)
        elif cut.is_error:
            self._keep_unknown(cut)

    def _keep(self, hit: Hit, number: int, line: str) -> None:
        known = self._known.get(hit.message.id)
        values = dict(hit.match.values)
        if known is None:
            text = single_blanks(line)
            start = text.rfind(" ", 0, hit.match.start) + 1 if not hit.pattern.literals[0] else hit.match.start
            self._known[hit.message.id] = Known(hit.message, number, 1, text[start:], (values,))
            return
        more = (values,) if values not in known.values and len(known.values) < _MOST_VALUES else ()
        self._known[hit.message.id] = known._replace(times=known.times + 1, values=known.values + more)

    def _keep_unknown(self, cut: _Wrapped) -> None:
        known = self._unknown.get(cut.text)
        if known is not None:
            self._unknown[cut.text] = known._replace(times=known.times + 1)
        elif len(self._unknown) < _MOST_UNKNOWN:
            self._unknown[cut.text] = Unknown(cut.number, 1, cut.text, self._partial.nearest(cut.text))


def _is_suspicious(line: str) -> bool:
    """Whether a line looks like an error or a warning."""
    return _SUSPICIOUS.search(line) is not None and _NOT_SUSPICIOUS.search(line) is None


def plain(line: str) -> str:
    """Return a line without the prefixes of its message: times, levels, names of nodes and files."""
    text, at = single_blanks(line), 0
    for _ in range(_MOST_PREFIXES):
        prefix = _PREFIX.match(text, at)
        if prefix is None:
            break
        at = prefix.end()
    return text[at:]
