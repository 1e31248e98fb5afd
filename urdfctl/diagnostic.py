"""What a rule yields, and what a user gets."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from urdfctl.record import NamedTuple
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceSpan


class Severity(Enum):
    """How bad a finding is."""

    ERROR = "error"
    """The robot does not load, start or move."""
    WARNING = "warning"
    """It loads and is wrong, or will break."""
    INFO = "info"
    """Worth knowing."""

    @property
    def weight(self) -> int:
        """3 for an error, 2 for a warning, 1 for information."""
        return {"error": 3, "warning": 2, "info": 1}[self.value]


class Edit(NamedTuple):
    """Bytes of one source file to be replaced."""

    span: SourceSpan
    text: str


class Fix(NamedTuple):
    """A repair: what it does, its edits (none where only a person can make them), and whether it is surely meant."""

    title: str
    edits: tuple[Edit, ...] = ()
    safe: bool = False


class Note(NamedTuple):
    """A further word on a finding, with a place where there is one."""

    message: str
    at: Place | None = None


class Finding(NamedTuple):
    """What a rule yields. `severity` is given only where it differs from the rule's own."""

    at: Place
    message: str
    notes: tuple[Note, ...] = ()
    fix: Fix | None = None
    severity: Severity | None = None


class Location(NamedTuple):
    """A span as reports show it: lines and columns from 1, offsets in bytes from 0."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    start: int
    end: int


class Step(NamedTuple):
    """One call on the way to a finding: `what` is `macro wheel`, `include x.xacro` or `block`."""

    file: str
    line: int
    column: int
    what: str


class Remark(NamedTuple):
    """A note as reports show it."""

    message: str
    at: Location | None = None


class Replacement(NamedTuple):
    """An edit as reports show it: what stands at a place becomes `text`."""

    at: Location
    text: str

    @property
    def file(self) -> str:
        """The file to be changed."""
        return self.at.file

    @property
    def start(self) -> int:
        """The first byte that is replaced."""
        return self.at.start

    @property
    def end(self) -> int:
        """The byte after the last one that is replaced."""
        return self.at.end


class Repair(NamedTuple):
    """A fix as reports show it."""

    title: str
    safe: bool
    edits: tuple[Replacement, ...] = ()


class Diagnostic(NamedTuple):
    """What a user gets: plain data, free of the trees it came from. `excerpt` is the source line it starts on, or of a
    long one the part around it; `excerpt_column` tells where that part begins."""

    code: str
    name: str
    severity: Severity
    message: str
    at: Location
    expanded_from: tuple[tuple[Step, ...], ...] = ()
    notes: tuple[Remark, ...] = ()
    fix: Repair | None = None
    excerpt: str = ""
    url: str | None = None
    excerpt_column: int = 1

    @property
    def order(self) -> tuple[Location, str, str]:
        """The key of the stable order of a report."""
        return self.at, self.code, self.message

    @property
    def in_macro(self) -> bool:
        """Whether it stands in what a macro's call, or an inserted block, brought in."""
        return any(not step.what.startswith("include") for chain in self.expanded_from for step in chain)


def diagnosed(code: str, name: str, severity: Severity, finding: Finding, url: str | None = None) -> Diagnostic:
    """The plain data of a finding."""
    fix = finding.fix
    at = located(finding.at.span)
    excerpt, excerpt_column = _excerpt(finding.at.source.line(at.line), at.column)
    return Diagnostic(
        code,
        name,
        severity,
        _told(finding.message),
        at,
        _chains(finding.at),
        tuple(Remark(_told(note.message), located(note.at.span) if note.at else None) for note in finding.notes),
        Repair(_told(fix.title), fix.safe, _replacements(fix.edits)) if fix else None,
        excerpt,
        url,
        excerpt_column,
    )


_MOST_EXCERPT = 400


def _excerpt(line: str, column: int) -> tuple[str, int]:
    """What is worth keeping of a line, and the column it begins at: a robot may stand on one line, and have a thousand
    faults there."""
    if len(line) <= _MOST_EXCERPT:
        return line, 1
    start = max(0, column - 1 - _MOST_EXCERPT // 2)
    return line[start : start + _MOST_EXCERPT], start + 1


def _told(message: str) -> str:
    """A message as people read it: what is not known stands in it as a question mark."""
    return message.replace(UNKNOWN, "?")


def located(span: SourceSpan) -> Location:
    """A span with its lines and columns worked out."""
    start, end = span.source.position(span.start), span.source.position(span.end)
    return Location(span.file, start.line, start.column, end.line, end.column, span.start, span.end)


def _chains(place: Place) -> tuple[tuple[Step, ...], ...]:
    if place.call is None:
        return ()
    return (
        tuple(
            Step(call.source.path, *call.source.position(call.offset), f"{call.kind} {call.name}".strip())
            for call in place.call.chain()
        ),
    )


def _replacements(edits: Sequence[Edit]) -> tuple[Replacement, ...]:
    return tuple(Replacement(located(edit.span), edit.text) for edit in edits)
