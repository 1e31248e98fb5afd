"""Summarize a log: each known message once, with its count and first line, and the unknown lines."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import chain, islice

from urdfctl.catalog.distros import ALL
from urdfctl.catalog.log_messages import KINDS, LogMessage
from urdfctl.logs.evidence import MessageMeaning, reading
from urdfctl.logs.index import Hit, Spelling, found_among, index, loose_index
from urdfctl.logs.line import PROCESS, LogLine, plain, records
from urdfctl.logs.partial import partial
from urdfctl.logs.pattern import single_blanks
from urdfctl.startup.records import NamedTuple

_MOST_VALUES = 100
"""Distinct sets of values kept per message, and processes that print it."""
_MOST_UNKNOWN = 100
"""Distinct unknown lines kept."""
_MOST_SEARCHES = 400
"""Slow searches for partial messages, one per distinct line; numbers in a line do not count."""
_MOST_WRAPPED = 6
"""Lines over which a message may be wrapped."""
_MOST_CANDIDATES = 3
"""Messages reported for a truncated pasted line; with more candidates, the line is unknown."""
_SHORT = 40
"""Lines up to which a log is read like pasted lines: those without a level may be errors too."""
_TRACED = re.compile(r'^\W*File ".+", line \d+, in \S+$')
_EVERYWHERE = "*"
"""Stands for all processes."""
_WITHIN_NAME = re.compile(r"[A-Za-z0-9]_$")
_INSTALLED = "/opt/ros/"
_LEVELS = ("error", "warning", "", "info")
_URGENT = ("failure", "consequence", "warning")
_SAYS_NOTHING = re.compile(r"\s*\* /|\W*(?:\w+\W*){0,2}$")
"""Lines of at most two words, and roslaunch's list of parameters, are not listed as unknown."""


class KnownMessage(NamedTuple):
    """A known message in a log.

    line: the number of its first line. times: how often it occurs. text: the text of its first occurrence.
    values: the values by name, once per distinct set. settled: the line in which a later message makes it harmless,
    0 if there is none. reading: what it means in this log.
    """

    message: LogMessage
    line: int
    times: int
    text: str
    values: tuple[dict[str, str], ...]
    settled: int = 0
    reading: MessageMeaning = MessageMeaning("", (), "")

    @property
    def kind(self) -> str:
        """The kind of the message; a message that was settled is harmless."""
        return "harmless" if self.settled else self.message.kind

    @property
    def rules(self) -> tuple[str, ...]:
        """The codes of the rules that find its causes, most likely first."""
        return tuple(dict.fromkeys(code for cause in self.reading.causes for code in cause.rules))


class Unknown(NamedTuple):
    """An unknown text.

    level: "error", "warning", "info", or "" if the line has none. nearest: the most similar known message, None if none
    is similar.
    """

    line: int
    times: int
    text: str
    level: str
    nearest: Spelling | None


class Digest(NamedTuple):
    """The known messages (most urgent first, then by line) and the unknown lines (errors first).

    lines: number of lines read. distro: the ROS distro in the log's paths (/opt/ros/humble), "" if there is none.
    """

    lines: int
    known: tuple[KnownMessage, ...]
    unknown: tuple[Unknown, ...]
    distro: str = ""


def digest(lines: Iterable[str], *, pasted: bool, distro: str | None = None) -> Digest:
    """Return the messages in the lines.

    pasted: search every line for partial messages; otherwise only lines that look like errors, or all lines without
    a level if there are few. distro: of the user; by default the one that the log shows.
    """
    rest = _with_whole_names(lines) if pasted else iter(lines)
    first = list(islice(rest, _SHORT + 1))
    reader = _LogReader(pasted=pasted, short=len(first) <= _SHORT, distro=distro)
    for line in chain(first, rest):
        reader.read(line)
    return reader.finished()


def _with_whole_names(lines: Iterable[str]) -> Iterator[str]:
    """Pasted lines, joined where one ends within a name, after an underscore."""
    begun = ""
    for line in lines:
        begun += line.lstrip() if begun else line
        if not _WITHIN_NAME.search(begun.rstrip()):
            yield begun
            begun = ""
        else:
            begun = begun.rstrip()
    if begun:
        yield begun


class _Wrapped(NamedTuple):
    """A line that may end in the middle of a message, which continues in the next line.

    quiet: whether it is not reported if it does not continue.
    """

    number: int
    line: LogLine
    text: str
    hits: tuple[Hit, ...]
    lines: int = 1
    quiet: bool = False


class _LogReader:
    """Read lines one by one and collect the messages."""

    def __init__(self, *, pasted: bool, short: bool, distro: str | None = None) -> None:
        self._index = index()
        self._partial = partial()
        self._pasted = pasted
        self._short = short
        self._number = 0
        self._distro = distro or ""
        self._known: dict[str, KnownMessage] = {}
        self._last: dict[str, dict[str, int]] = {}
        """By the id of a message, the last line in which each process prints it."""
        self._settling: dict[str, dict[str, int]] = {}
        """The same for the messages that make it harmless."""
        self._unknown: dict[str, Unknown] = {}
        self._searched: dict[str, tuple[Hit, ...]] = {}
        self._wrapped: _Wrapped | None = None
        self._ended: set[str] = set()
        """The ids of messages that are normal from here on."""
        self._code_follows = False
        """Whether the next line is a line of code in a traceback of Python."""

    def read(self, line: str) -> None:
        """Read the next line."""
        self._number += 1
        if not self._distro and _INSTALLED in line:
            name = line.split(_INSTALLED, 1)[1].split("/", 1)[0]
            self._distro = name if name in ALL else ""
        for record in records(line):
            self._read(record)

    def _read(self, line: LogLine) -> None:
        hits = self._index.hits(line.text)
        wrapped, self._wrapped = self._wrapped, None
        if wrapped and (not hits or wrapped.quiet) and self._continues(wrapped, line):
            return
        if wrapped:
            self._record(wrapped)
        for hit in hits:
            self._keep(hit, self._number, line)
        if hits:
            self._search_open_end(hits[-1], line)
        elif self._is_searched(line) and line.text.strip() and not self._code_follows:
            self._search_partial(line)
        self._code_follows = _TRACED.search(line.text) is not None

    def finished(self) -> Digest:
        """Return the collected messages."""
        if self._wrapped:
            self._record(self._wrapped)
        seen = self._known.keys()
        known = [self._read_in_context(entry, seen) for entry in self._known.values()]
        shown = [entry for entry in known if entry.kind != "progress"]
        shown.sort(key=lambda entry: (KINDS.index(entry.kind), entry.line))
        unknown = sorted(self._unknown.values(), key=lambda entry: _LEVELS.index(entry.level))
        return Digest(self._number, tuple(shown), tuple(unknown), self._distro)

    def _read_in_context(self, known: KnownMessage, seen: Iterable[str]) -> KnownMessage:
        message = known.message
        return known._replace(
            settled=self._settled(message.id) if message.kind in _URGENT else 0,
            reading=reading(message, known.values[0], frozenset(seen), self._distro),
        )

    def _settled(self, name: str) -> int:
        """The line that settles a message of each process that printed it; 0 if one of them is not settled."""
        settling = self._settling.get(name, {})
        settled = 0
        for process, last in self._last[name].items():
            later = [
                line
                for other, line in settling.items()
                if other == _EVERYWHERE or (line >= last and (not process or other in {"", process}))
            ]
            if not later:
                return 0
            settled = max(settled, *later)
        return settled

    def _is_searched(self, line: LogLine) -> bool:
        """Whether a line without known messages is searched for partial ones, and listed as unknown."""
        if self._pasted:
            return line.level != "info" or not self._known
        if line.level:
            return line.level != "info"
        return self._short and _SAYS_NOTHING.match(line.text) is None

    def _search_partial(self, line: LogLine) -> None:
        """Search for a message that is written differently or truncated in a line without a complete one."""
        text = plain(line.text)
        hits = loose_index().hits(text)
        if hits:
            for hit in hits:
                self._keep(hit, self._number, line._replace(text=text), loose=True)
            return
        found = self._cut(text)
        if found is None:
            return
        cut = _Wrapped(self._number, line, text, found)
        if found:
            self._wrapped = cut
        else:
            self._record(cut)

    def _search_open_end(self, hit: Hit, line: LogLine) -> None:
        """Search for the beginning of a message behind one that names its reason, which goes on in the next line."""
        rest = single_blanks(line.text)[hit.match.end :].strip(" :")
        if hit.message.kind != "consequence" or " " not in rest:
            return
        begun = tuple(one for one in self._cut(rest) or () if one.message.id != hit.message.id)
        if begun:
            self._wrapped = _Wrapped(self._number, line, rest, begun, quiet=True)

    def _cut(self, text: str) -> tuple[Hit, ...] | None:
        """The messages in which a text begins or ends, or which it surely means; None after too many searches."""
        shape = re.sub(r"\d+", "0", text)
        if shape not in self._searched:
            if len(self._searched) >= _MOST_SEARCHES:
                return None
            self._searched[shape] = tuple(self._partial.cut(text)) or tuple(self._partial.similar(text))
        return self._searched[shape]

    def _continues(self, wrapped: _Wrapped, line: LogLine) -> bool:
        """Whether a line continues the message in which the line before ends."""
        text = single_blanks(PROCESS.sub("", line.text, count=1))
        spellings = [Spelling(hit.message, hit.pattern) for hit in wrapped.hits]
        for joined in (f"{wrapped.text} {text}", wrapped.text + text):
            hits = found_among(spellings, joined)
            if hits:
                self._keep(hits[0], wrapped.number, wrapped.line._replace(text=joined))
                return True
        for joined in (f"{wrapped.text} {text}", wrapped.text + text):
            longer = tuple(self._partial.cut(joined)) if wrapped.lines < _MOST_WRAPPED else ()
            if longer and {hit.message.id for hit in longer} <= {hit.message.id for hit in wrapped.hits}:
                self._wrapped = wrapped._replace(text=joined, hits=longer, lines=wrapped.lines + 1)
                return True
        return False

    def _record(self, cut: _Wrapped) -> None:
        """Record a line that does not continue: a truncated message, or an unknown one."""
        if cut.quiet:
            return
        if cut.hits and len(cut.hits) <= (_MOST_CANDIDATES if self._pasted else 1):
            for hit in cut.hits:
                self._keep(hit, cut.number, cut.line._replace(text=cut.text))
        else:
            self._keep_unknown(cut)

    def _keep(self, hit: Hit, number: int, line: LogLine, *, loose: bool = False) -> None:
        message = hit.message
        if message.id in self._ended or (line.level == "info" and message.kind in _URGENT and not message.info):
            return
        self._ended.update(message.ends)
        for name in message.settles:
            _add(self._settling.setdefault(name, {}), _EVERYWHERE if message.everywhere else line.process, number)
        _add(self._last.setdefault(message.id, {}), line.process, number)
        known = self._known.get(message.id)
        values = dict(hit.match.values)
        if known is None:
            text = single_blanks(line.text)
            start = text.rfind(" ", 0, hit.match.start) + 1 if not hit.pattern.literals[0] else hit.match.start
            self._known[message.id] = KnownMessage(message, number, 1, text if loose else text[start:], (values,))
            return
        more = (values,) if values not in known.values and len(known.values) < _MOST_VALUES else ()
        self._known[message.id] = known._replace(times=known.times + 1, values=known.values + more)

    def _keep_unknown(self, cut: _Wrapped) -> None:
        known = self._unknown.get(cut.text)
        if known is not None:
            self._unknown[cut.text] = known._replace(times=known.times + 1)
        elif len(self._unknown) < _MOST_UNKNOWN:
            nearest = self._partial.nearest(cut.text)
            self._unknown[cut.text] = Unknown(cut.number, 1, cut.text, cut.line.level, nearest)


def _add(lines: dict[str, int], process: str, number: int) -> None:
    if process in lines or len(lines) < _MOST_VALUES:
        lines[process] = number
