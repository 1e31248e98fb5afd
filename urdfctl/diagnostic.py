"""Findings, as rules yield them, and diagnostics, as reports show them."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place, SourceSpan
from urdfctl.startup.records import NamedTuple


class Severity(Enum):
    """The severity of a finding."""

    ERROR = "error"
    """The robot does not load, start or move."""
    WARNING = "warning"
    """The robot loads but is wrong, or will break later."""
    INFO = "info"
    """Worth knowing."""

    @property
    def weight(self) -> int:
        """3 for an error, 2 for a warning, 1 for info."""
        return {"error": 3, "warning": 2, "info": 1}[self.value]

    @property
    def milder(self) -> Severity:
        """The severity one step below; info stays info."""
        return Severity.WARNING if self is Severity.ERROR else Severity.INFO


class Edit(NamedTuple):
    """A replacement of bytes in one source file."""

    span: SourceSpan
    text: str


class Fix(NamedTuple):
    """A fix for a finding."""

    title: str
    """What the fix does, in the imperative."""
    edits: tuple[Edit, ...] = ()
    """Empty if the fix must be made by hand."""
    safe: bool = False
    """Whether the fix is certainly what was meant."""
    doubt: str = ""
    """Why it is not; empty for the usual reason: another name or value may be meant."""


class Note(NamedTuple):
    """Additional information about a finding, with a place if there is one."""

    message: str
    at: Place | None = None


class Finding(NamedTuple):
    """A fault that a rule found. `severity` is None unless it differs from the rule's own severity."""

    at: Place
    message: str
    notes: tuple[Note, ...] = ()
    fix: Fix | None = None
    severity: Severity | None = None


class Location(NamedTuple):
    """A span as reports show it. Lines and columns count from 1, offsets are in bytes and count from 0."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    start: int
    end: int


class CallStep(NamedTuple):
    """One call in the chain that leads to a finding. `what` is `macro wheel`, `include x.xacro` or `block`."""

    file: str
    line: int
    column: int
    what: str


class Remark(NamedTuple):
    """A note as reports show it."""

    message: str
    at: Location | None = None


class ShownEdit(NamedTuple):
    """An edit as reports show it: the text at a place is replaced by `text`."""

    at: Location
    text: str

    @property
    def file(self) -> str:
        """The file to change."""
        return self.at.file

    @property
    def start(self) -> int:
        """The offset of the first byte that is replaced."""
        return self.at.start

    @property
    def end(self) -> int:
        """The offset after the last byte that is replaced."""
        return self.at.end


class Repair(NamedTuple):
    """A fix as reports show it."""

    title: str
    safe: bool
    edits: tuple[ShownEdit, ...] = ()
    doubt: str = ""

    @property
    def reason(self) -> str:
        """Why it is not safe, in words; empty if it is, or must be made by hand."""
        if self.safe or not self.edits:
            return ""
        if self.doubt:
            return self.doubt
        if not any(edit.text for edit in self.edits):
            return "what it removes may be used elsewhere"
        is_added = all(edit.start == edit.end for edit in self.edits)
        return "it may be elsewhere, or not wanted" if is_added else "something else may be meant"


class Diagnostic(NamedTuple):
    """A finding as plain data, without references to the source trees.

    `excerpt` is the source line that the finding starts on, or the part of a long line around it. `excerpt_column` is
    the column at which that part begins, from 1. `also` are the equal findings of the file that it was joined with.
    """

    code: str
    name: str
    severity: Severity
    message: str
    at: Location
    expanded_from: tuple[tuple[CallStep, ...], ...] = ()
    notes: tuple[Remark, ...] = ()
    fix: Repair | None = None
    excerpt: str = ""
    url: str | None = None
    excerpt_column: int = 1
    also: tuple[Remark, ...] = ()

    @property
    def order(self) -> tuple[Location, str, str]:
        """The sort key that gives a report its stable order."""
        return self.at, self.code, self.message

    @property
    def in_macro(self) -> bool:
        """Whether it is in the content of a macro call or an inserted block."""
        return any(not step.what.startswith("include") for chain in self.expanded_from for step in chain)


def diagnosed(code: str, name: str, severity: Severity, finding: Finding, url: str | None = None) -> Diagnostic:
    """Return a finding as plain data."""
    fix = finding.fix
    at = located(finding.at.span)
    excerpt, excerpt_column = excerpt_at(finding.at.span)
    return Diagnostic(
        code=code,
        name=name,
        severity=severity,
        message=_readable(finding.message),
        at=at,
        expanded_from=_chains(finding.at),
        notes=tuple(
            Remark(_readable(note.message), located(note.at.span) if note.at else None) for note in finding.notes
        ),
        fix=Repair(_readable(fix.title), fix.safe, _replacements(fix.edits), fix.doubt) if fix else None,
        excerpt=excerpt,
        url=url,
        excerpt_column=excerpt_column,
    )


_MOST_EXCERPT = 400


def excerpt_at(span: SourceSpan) -> tuple[str, int]:
    """Return the part of a span's first line to show, and its first column, from 1.

    It is limited because a robot may be written on one line and have a thousand faults there.
    """
    return span.source.excerpt(span.start, _MOST_EXCERPT)


def _readable(message: str) -> str:
    """A message with a question mark for each unknown part."""
    return message.replace(UNKNOWN, "?")


def located(span: SourceSpan) -> Location:
    """Return the location of a span, with its lines and columns."""
    start, end = span.source.position(span.start), span.source.position(span.end)
    return Location(
        file=span.file,
        line=start.line,
        column=start.column,
        end_line=end.line,
        end_column=end.column,
        start=span.start,
        end=span.end,
    )


def _chains(place: Place) -> tuple[tuple[CallStep, ...], ...]:
    if place.call is None:
        return ()
    return (
        tuple(
            CallStep(call.source.path, *call.source.position(call.offset), f"{call.kind} {call.name}".strip())
            for call in place.call.chain()
        ),
    )


def _replacements(edits: Sequence[Edit]) -> tuple[ShownEdit, ...]:
    return tuple(ShownEdit(located(edit.span), edit.text) for edit in edits)
