"""One application of all steps of a migration to a copy of the packages."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Edit
from urdfctl.fix.edits import Shift, Splice, Taken, clash, edited
from urdfctl.migrate.edits.python_edits import is_python
from urdfctl.migrate.packages import Lint, Linted, MigratedPackages
from urdfctl.migrate.report import NOT_CHANGED
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Step
from urdfctl.migrate.todo import with_todos
from urdfctl.migrate.trial.acceptance import Before, Objection, objections
from urdfctl.output.change import bytes_of

MOST_ROUNDS = 12

Key = tuple[str, str]
"""A step and a file that it changes, by name and real path."""
Barred = Mapping[Key, str]
"""The steps that must not change a file, with the objection."""


class Noted:
    """An entry for the report, and the offset of its place in the file as it is now."""

    __slots__ = ("entry", "offset", "step")

    def __init__(self, step: str, entry: ReportEntry) -> None:
        self.step, self.entry = step, entry
        self.offset = entry.at.span.start if entry.at else 0

    def copy(self) -> Noted:
        """Return the same entry, at the same place now."""
        other = Noted(self.step, self.entry)
        other.offset = self.offset
        return other

    @property
    def file(self) -> str:
        """The path of the file; empty if it is about no file."""
        return self.entry.at.source.path if self.entry.at else self.entry.file

    @property
    def key(self) -> tuple[EntryKind, str, str, int]:
        """What makes an entry the same as another."""
        return self.entry.kind, self.entry.message, self.file, self.offset


class Attempt:
    """One application of all steps.

    touched: the steps with the files that they changed, in order.
    linted: the findings for the target afterwards; empty if nothing changed.
    noted: the entries for the report, with those of an accepted attempt before, on whose result this one is based.
    """

    def __init__(self, packages: MigratedPackages, barred: Barred, earlier: Sequence[Noted] = ()) -> None:
        self.packages = packages
        self.barred = barred
        self.touched: dict[Key, None] = {}
        self.linted: Linted = ()
        self.noted = [noted.copy() for noted in earlier]
        self._claims: dict[str, frozenset[str]] = {}
        self._moved: frozenset[str] = frozenset()

    def copy(self, barred: Barred) -> Attempt:
        """Return an attempt that applied the same steps so far, and will apply further ones without those barred."""
        other = Attempt(self.packages, barred, self.noted)
        other.touched = dict(self.touched)
        other._claims, other._moved = dict(self._claims), self._moved
        return other

    def apply(self, step: Step) -> None:
        """Apply a step until it proposes no more changes."""
        left: list[Proposal] = []
        for _ in range(MOST_ROUNDS):
            is_changed, left = self._round(step)
            if not is_changed:
                break
        self._note_left(step, left)

    def _round(self, step: Step) -> tuple[bool, list[Proposal]]:
        """Apply what a step proposes now; return whether that changed anything, and the proposals that clash."""
        proposals = map(with_todos, step.propose(self.packages))
        pending = [proposal for proposal in proposals if self._is_admitted(step, proposal)]
        is_changed = False
        while pending and not is_changed:
            taken = Taken()
            chosen: list[Proposal] = []
            left: list[Proposal] = []
            for proposal in pending:
                (chosen if taken.take(_splices(proposal)) else left).append(proposal)
            if not chosen:
                break
            is_changed, pending = self._apply(step, chosen), left
        return is_changed, pending

    def _apply(self, step: Step, chosen: Sequence[Proposal]) -> bool:
        splices: dict[str, set[Splice]] = {}
        for proposal in chosen:
            self._note(step, proposal)
            for splice in _splices(proposal):
                splices.setdefault(splice.file, set()).add(splice)
        effective = [*self._edit(splices), *self._create(chosen)]
        if effective:
            self.packages.forget()
        return bool(effective)

    def _is_admitted(self, step: Step, proposal: Proposal) -> bool:
        files = [os.path.realpath(file) for file in proposal.files]
        for path in _broken(proposal):
            message = f"{NOT_CHANGED} '{step.name}': the result would be no valid Python"
            self.noted.append(Noted(step.name, ReportEntry(EntryKind.FOR_YOU, message, file=path)))
            return False
        return all(self.packages.may_change(file) and (step.name, file) not in self.barred for file in files)

    def _note(self, step: Step, proposal: Proposal) -> None:
        for file in sorted(proposal.files):
            real = os.path.realpath(file)
            self.touched[step.name, real] = None
            self._claims[real] = self._claims.get(real, frozenset()) | set(proposal.fixes)
        self._moved |= proposal.moves
        known = {noted.key for noted in self.noted}
        new = (Noted(step.name, entry) for entry in proposal.entries)
        self.noted += [noted for noted in new if noted.key not in known]

    def _note_left(self, step: Step, proposals: Iterable[Proposal]) -> None:
        """Note the files of proposals that clash with themselves, or with others until the last round."""
        for file in sorted({file for proposal in proposals for file in proposal.files}):
            message = f"{NOT_CHANGED} '{step.name}': its changes overlap"
            self.noted.append(Noted(step.name, ReportEntry(EntryKind.FOR_YOU, message, file=file)))

    def _edit(self, splices: dict[str, set[Splice]]) -> Iterator[str]:
        for file, own in splices.items():
            old = bytes_of(file) or b""
            new = edited(old, own)
            if new != old:
                self.packages.scratch.write(file, new)
                shift = Shift(own)
                for noted in self.noted:
                    if noted.file and os.path.realpath(noted.file) == file:
                        noted.offset = shift.near(noted.offset)
                yield file

    def _create(self, proposals: Sequence[Proposal]) -> Iterator[str]:
        for proposal in proposals:
            replaced = {path: bytes_of(path) or b"" for path in proposal.deleted}
            for path in proposal.deleted:
                if os.path.lexists(path):
                    self.packages.scratch.write(path, None)
                    yield path
            for path, text in proposal.created:
                data = _with_line_ends_of(replaced.get(path, b""), text).encode("utf-8", "surrogateescape")
                if not os.path.lexists(path) and bytes_of(path) != data:
                    self.packages.scratch.write(path, data)
                    yield path

    def judged(self, state: Before, lint: Lint, settings: Settings) -> list[Objection]:
        """Return the objections to what was applied."""
        self.linted = lint(settings._replace(distro=self.packages.options.target))
        return list(objections(state, self.linted, self.packages.loaded(), self._claims, self._moved))


def _broken(proposal: Proposal) -> Iterator[str]:
    """Yield the files in Python that a proposal would make invalid."""
    for path in {edit.span.file for edit in proposal.edits if edit.span.file.endswith(".py")}:
        own = {splice for splice in _splices(proposal) if splice.file == os.path.realpath(path)}
        old = bytes_of(path) or b""
        if is_python(old) and not is_python(edited(old, own)):
            yield path


def _splice(edit: Edit) -> Splice:
    span = edit.span
    text = _with_line_ends_of(span.source.data, edit.text)
    return Splice(os.path.realpath(span.file), span.start, span.end, text)


def _splices(proposal: Proposal) -> list[Splice]:
    """The edits of a proposal. Where they touch, they are one edit, in the order of the proposal."""
    splices = sorted(
        dict.fromkeys(map(_splice, proposal.edits)), key=lambda splice: (splice.file, splice.start, splice.end)
    )
    joined: list[Splice] = []
    for splice in splices:
        last = joined[-1] if joined else None
        if last and last.end == splice.start and clash(last, splice):
            joined[-1] = last._replace(end=splice.end, text=last.text + splice.text)
        else:
            joined.append(splice)
    return joined


def _with_line_ends_of(data: bytes, text: str) -> str:
    """Return a text with CRLF at the ends of its lines if most lines of a file end so."""
    is_crlf = 2 * data.count(b"\r\n") > data.count(b"\n")
    return re.sub(r"(?<!\r)\n", "\r\n", text) if is_crlf and "\n" in text else text
