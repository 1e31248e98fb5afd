"""What a log says: each known message once, with how often and where, and the errors that are not known."""

from __future__ import annotations

import re
from collections.abc import Iterable

from urdfctl.catalog.log_messages import KINDS, LogMessage
from urdfctl.logs.index import Hit, Spelling, found_among, index
from urdfctl.logs.partial import partial
from urdfctl.logs.pattern import single_blanks
from urdfctl.record import NamedTuple

_MOST_NAMES = 100
_MOST_UNKNOWN = 100
_MOST_LOOKS = 400
_MOST_WRAPPED = 6
_MOST_PREFIXES = 12
_SURE = 3
_STRAIGHT = str.maketrans("‘’“”", "''\"\"")  # noqa: RUF001 (web pages make them of straight ones)
_LEVELS = r"ERROR|Error|error|Err|FATAL|Fatal|critical|WARN|WARNING|Warning|warning|Wrn"
_SUSPICIOUS = re.compile(rf"\[\s*(?:{_LEVELS})\s*\]|\b(?:{_LEVELS})\b\s*:|\b[Ee]xception\b|what\(\):")
_CALM = re.compile(r"\[\s*(?:INFO|DEBUG|Msg|Dbg|info|debug)\s*\]")
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
    """A message in a log: its first line, how many times it stands there, its first text, and the values in each."""

    message: LogMessage
    line: int
    times: int
    text: str
    values: tuple[dict[str, str], ...]


class Unknown(NamedTuple):
    """A text that no message is known for; `nearest` is the one most like it, where one is."""

    line: int
    times: int
    text: str
    nearest: Spelling | None


class Digest(NamedTuple):
    """The known messages, the most urgent and earliest first, and the unknown errors, of a number of lines."""

    lines: int
    known: tuple[Known, ...]
    unknown: tuple[Unknown, ...]


def digest(lines: Iterable[str], *, pasted: bool) -> Digest:
    """What the lines say. Each line of a pasted text is looked at closely, of a log those that look like errors."""
    reader = _Reader(pasted=pasted)
    for line in lines:
        reader.read(line)
    return reader.finished()


class _Wrapped(NamedTuple):
    """A line that ends within messages, and may go on in the next one."""

    number: int
    text: str
    hits: tuple[Hit, ...]
    is_error: bool
    lines: int = 1


class _Reader:
    """Keeps what was found so far."""

    def __init__(self, *, pasted: bool) -> None:
        self._index = index()
        self._partial = partial()
        self._pasted = pasted
        self._number = 0
        self._known: dict[str, Known] = {}
        self._unknown: dict[str, Unknown] = {}
        self._looks: dict[str, tuple[Hit, ...]] = {}
        self._wrapped: _Wrapped | None = None

    def read(self, line: str) -> None:
        """Take the next line."""
        self._number += 1
        if self._pasted and not line.isascii():
            line = line.translate(_STRAIGHT)
        hits = self._index.hits(line)
        wrapped, self._wrapped = self._wrapped, None
        if wrapped and not hits and self._goes_on(wrapped, line):
            return
        if wrapped:
            self._take_cut(wrapped)
        for hit in hits:
            self._keep(hit, self._number, line)
        if not hits and (self._pasted or _is_suspicious(line)) and line.strip():
            self._look(line)

    def finished(self) -> Digest:
        """All that was found."""
        if self._wrapped:
            self._take_cut(self._wrapped)
        known = sorted(self._known.values(), key=lambda one: (KINDS.index(one.message.kind), one.line))
        return Digest(self._number, tuple(known), tuple(self._unknown.values()))

    def _look(self, line: str) -> None:
        """Look closely at a line in which no message is whole."""
        text = plain(line)
        shape = re.sub(r"\d+", "0", text)
        if shape not in self._looks:
            if len(self._looks) >= _MOST_LOOKS:
                return
            self._looks[shape] = tuple(self._partial.cut(text))
        is_error = self._pasted or _ERROR.search(line) is not None
        cut = _Wrapped(self._number, text, self._looks[shape], is_error)
        if cut.hits:
            self._wrapped = cut
        else:
            self._take_cut(cut)

    def _goes_on(self, wrapped: _Wrapped, line: str) -> bool:
        """Whether a line goes on with the message that the one before ends within."""
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

    def _take_cut(self, cut: _Wrapped) -> None:
        """Take a line as it is: a message that is cut, or unknown."""
        if cut.hits and len(cut.hits) <= (_SURE if self._pasted else 1):
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
        more = (values,) if values not in known.values and len(known.values) < _MOST_NAMES else ()
        self._known[hit.message.id] = known._replace(times=known.times + 1, values=known.values + more)

    def _keep_unknown(self, cut: _Wrapped) -> None:
        known = self._unknown.get(cut.text)
        if known is not None:
            self._unknown[cut.text] = known._replace(times=known.times + 1)
        elif len(self._unknown) < _MOST_UNKNOWN:
            self._unknown[cut.text] = Unknown(cut.number, 1, cut.text, self._partial.nearest(cut.text))


def _is_suspicious(line: str) -> bool:
    """Whether a line looks like an error or a warning."""
    return _SUSPICIOUS.search(line) is not None and _CALM.search(line) is None


def plain(line: str) -> str:
    """A line without what is put before the message: times, levels, names of nodes and files."""
    text, at = single_blanks(line), 0
    for _ in range(_MOST_PREFIXES):
        found = _PREFIX.match(text, at)
        if found is None:
            break
        at = found.end()
    return text[at:]
