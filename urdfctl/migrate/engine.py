"""Apply the steps of a migration to a copy of the packages, and keep what stands the test."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.fix.edits import Change, Shift, Splice, Taken, edited
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.acceptance import Before, Objection, before, objections
from urdfctl.migrate.memory import Memory
from urdfctl.migrate.packages import Lint, Linted, Packages
from urdfctl.migrate.report import ReportLine
from urdfctl.migrate.scratch import Scratch, bytes_of
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Step
from urdfctl.migrate.wishes import Wishes
from urdfctl.startup.records import NamedTuple

MOST_ROUNDS = 12
MOST_ATTEMPTS = 24
MOST_PASSES = 3


class Migration(NamedTuple):
    """The result of a migration; nothing is written yet.

    changes: the files to change, create or delete.
    lines: the report.
    """

    changes: tuple[Change, ...]
    lines: tuple[ReportLine, ...]


def migrate(scratch: Scratch, wishes: Wishes, settings: Settings, lint: Lint, steps: Sequence[Step]) -> Migration:
    """Return the migration of the packages in a copy.

    The steps are applied in order, then the whole is judged. If there are objections, the step that is responsible is
    left out in the files concerned, and all is done again. As a second run would begin with the result of that, all is
    repeated from there until nothing changes.

    settings: without a distro.
    """
    source = lint(settings._replace(distro=wishes.source))
    first, done, known = source, list[ReportLine](), Memory[LoadedTarget](scratch)
    for _ in range(MOST_PASSES):
        target = lint(settings._replace(distro=wishes.target))
        packages = Packages(scratch, wishes, settings, source, known)
        wanted = [step for step in steps if _is_wanted(step, packages)]
        state = before(source, target, packages.loaded())
        scratch.keep()
        attempt, found = _Trials(packages, wanted, state, lint, settings).best()
        done += attempt.done()
        if not attempt.barred or not attempt.touched:
            break
        source = lint(settings._replace(distro=wishes.source))  # what was left out may be possible now
    changes = scratch.changes()
    left = [*attempt.not_done(found), *_left(scratch, first, attempt)] if changes or attempt.barred else []
    return Migration(changes, (*done, *left))


def _left(scratch: Scratch, source: Linted, attempt: _Attempt) -> Iterator[ReportLine]:
    """Yield a line for each error that lint finds for the target, and did not find for the distro to migrate from."""
    known, errors = _errors(source), _errors(attempt.linted)
    for finding in (errors[key] for key in errors if key not in known and scratch.has(errors[key].at.file)):
        message = scratch.shown(f"lint finds {finding.code}: {finding.message}")
        yield ReportLine(EntryKind.FOR_YOU, message, "", scratch.real(finding.at.file), finding.at.line)


def _errors(linted: Linted) -> dict[tuple[str, str, str], Diagnostic]:
    """The errors, by what identifies them although their lines move."""
    found = (finding for _, result in linted for finding in result.outcome.diagnostics)
    return {(one.code, one.at.file, one.message): one for one in found if one.severity is Severity.ERROR}


def _is_wanted(step: Step, packages: Packages) -> bool:
    only = packages.wishes.only
    return (not only or step.part in only) and (step.generation != 1 or packages.is_ros1)


Barred = dict[tuple[str, str], str]
"""The steps that must not change a file, by step and real path, with the objection."""


class _Trials:
    """Attempts to apply all steps, each without those that the objections to the earlier ones bar."""

    def __init__(
        self, packages: Packages, steps: Sequence[Step], state: Before, lint: Lint, settings: Settings
    ) -> None:
        self.packages, self.steps = packages, steps
        self.state, self.lint, self.settings = state, lint, settings
        self.made = 0

    def best(self) -> tuple[_Attempt, list[Objection]]:
        """Return the last attempt, and the objections to it that no step is responsible for."""
        attempt, found = self._attempt({})
        hopeless: set[str] = set()
        while self.made < MOST_ATTEMPTS:
            objection = next((one for one in found if one.message not in hopeless), None)
            if objection is None:
                return attempt, found
            better = self._without_culprit(attempt, objection)
            if better is None:
                hopeless.add(objection.message)
            else:
                attempt, found = better
        everything = dict.fromkeys(attempt.touched, "too many changes would cause findings of a new kind")
        return self._attempt(everything) if found else (attempt, found)

    def _without_culprit(self, attempt: _Attempt, objection: Objection) -> tuple[_Attempt, list[Objection]] | None:
        """The attempt without the step that causes an objection, or without all that may; None if it stays."""
        candidates = _candidates(attempt, objection)
        if not candidates:
            return None
        choices = [[one] for one in candidates] + ([candidates] if len(candidates) > 1 else [])
        for choice in choices:
            if self.made >= MOST_ATTEMPTS:
                return None
            barred = {**attempt.barred, **dict.fromkeys(choice, objection.message)}
            other, found = self._attempt(barred)
            if all(one.kind != objection.kind for one in found):
                return other, found
        self._attempt(attempt.barred)
        return None

    def _attempt(self, barred: Barred) -> tuple[_Attempt, list[Objection]]:
        self.made += 1
        self.packages.scratch.reset()
        self.packages.forget()
        attempt = _Attempt(self.packages, barred)
        attempt.run(self.steps)
        found = attempt.judged(self.state, self.lint, self.settings) if self.packages.scratch.changes() else []
        return attempt, found


def _candidates(attempt: _Attempt, objection: Objection) -> list[tuple[str, str]]:
    """The steps that may be responsible for an objection: those that changed its own file first, the last one first."""
    own, files = os.path.realpath(objection.file), {os.path.realpath(file) for file in objection.files}
    touched = list(reversed(attempt.touched))
    direct = [key for key in touched if key[1] == own]
    return direct + [key for key in touched if key[1] in files and key not in direct]


class _Noted:
    """An entry for the report, and the offset of its place in the file as it is now."""

    __slots__ = ("entry", "offset", "step")

    def __init__(self, step: str, entry: Entry) -> None:
        self.step, self.entry = step, entry
        self.offset = entry.at.span.start if entry.at else 0

    @property
    def file(self) -> str:
        """The path of the file; empty if it is about no file."""
        return self.entry.at.source.path if self.entry.at else self.entry.file

    @property
    def key(self) -> tuple[EntryKind, str, str, int]:
        """What makes an entry the same as another."""
        return self.entry.kind, self.entry.message, self.file, self.offset


class _Attempt:
    """One application of all steps.

    touched: the steps with the files that they changed, in order, by name and real path.
    linted: the findings for the target afterwards; empty if nothing changed.
    """

    def __init__(self, packages: Packages, barred: Barred) -> None:
        self.packages = packages
        self.barred = barred
        self.touched: dict[tuple[str, str], None] = {}
        self.linted: Linted = ()
        self._claims: dict[str, frozenset[str]] = {}
        self._moved: frozenset[str] = frozenset()
        self._noted: list[_Noted] = []

    def run(self, steps: Iterable[Step]) -> None:
        """Apply steps, each until it proposes no more changes."""
        for step in steps:
            for _ in range(MOST_ROUNDS):
                if not self._round(step):
                    break

    def _round(self, step: Step) -> bool:
        taken = Taken()
        chosen = [
            proposal
            for proposal in step.propose(self.packages)
            if self._is_admitted(step, proposal) and taken.take(_splices(proposal))
        ]
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
        return all(self.packages.may_change(file) and (step.name, file) not in self.barred for file in files)

    def _note(self, step: Step, proposal: Proposal) -> None:
        for file in sorted(proposal.files):
            real = os.path.realpath(file)
            self.touched[step.name, real] = None
            self._claims[real] = self._claims.get(real, frozenset()) | set(proposal.fixes)
        self._moved |= proposal.moves
        known = {noted.key for noted in self._noted}
        new = (_Noted(step.name, entry) for entry in proposal.entries)
        self._noted += [noted for noted in new if noted.key not in known]

    def _edit(self, splices: dict[str, set[Splice]]) -> Iterator[str]:
        for file, own in splices.items():
            old = bytes_of(file) or b""
            new = edited(old, own)
            if new != old:
                self.packages.scratch.write(file, new)
                shift = Shift(own)
                for noted in self._noted:
                    if noted.file and os.path.realpath(noted.file) == file:
                        noted.offset = shift.near(noted.offset)
                yield file

    def _create(self, proposals: Sequence[Proposal]) -> Iterator[str]:
        for proposal in proposals:
            for path in proposal.deleted:
                if os.path.lexists(path):
                    self.packages.scratch.write(path, None)
                    yield path
            for path, text in proposal.created:
                data = text.encode("utf-8", "surrogateescape")
                if not os.path.lexists(path) and bytes_of(path) != data:
                    self.packages.scratch.write(path, data)
                    yield path

    def judged(self, state: Before, lint: Lint, settings: Settings) -> list[Objection]:
        """Return the objections to what was applied."""
        self.linted = lint(settings._replace(distro=self.packages.wishes.target))
        return list(objections(state, self.linted, self.packages.loaded(), self._claims, self._moved))

    def done(self) -> Iterator[ReportLine]:
        """Yield the report's lines on what was applied, with real paths and the lines of the migrated files."""
        scratch = self.packages.scratch
        for noted in self._noted:
            entry, file = noted.entry, scratch.real(noted.file) if noted.file else ""
            line = _line(noted.file, noted.offset) if entry.at and os.path.exists(noted.file) else 0
            message, more = scratch.shown(entry.message), (entry.authority, entry.option)
            yield ReportLine(entry.kind, message, noted.step, file, line, *more)

    def not_done(self, left: Sequence[Objection]) -> Iterator[ReportLine]:
        """Yield the report's lines on what was left out.

        left: the objections that no step is responsible for.
        """
        scratch = self.packages.scratch
        for (step, file), why in self.barred.items():
            message = scratch.shown(f"not changed by step '{step}': {why}")
            yield ReportLine(EntryKind.FOR_YOU, message, step, scratch.real(file))
        for objection in left:
            yield ReportLine(EntryKind.FOR_YOU, scratch.shown(objection.message))


def _splices(proposal: Proposal) -> list[Splice]:
    return [
        Splice(os.path.realpath(edit.span.file), edit.span.start, edit.span.end, edit.text) for edit in proposal.edits
    ]


def _line(path: str, offset: int) -> int:
    return (bytes_of(path) or b"")[:offset].count(b"\n") + 1
