"""Apply the steps of a migration to a copy of the packages, and keep what stands the test."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.catalog.distros import ROS1
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.findings.grouping import grouped
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.fixes import fixes_of_lint
from urdfctl.migrate.installs import installs_for_launch_files
from urdfctl.migrate.inventory import inventory
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.origins import check_direction, origins
from urdfctl.migrate.packages import Lint, Linted, MigratedPackages
from urdfctl.migrate.report import NOT_CHANGED, NOT_READ, ReportLine
from urdfctl.migrate.step import EntryKind, Step
from urdfctl.migrate.todo import without_punctuation
from urdfctl.migrate.trial.acceptance import Before, Objection, before
from urdfctl.migrate.trial.attempt import Attempt, Key, Noted
from urdfctl.migrate.trial.memory import Memory
from urdfctl.migrate.trial.scratch import Scratch, WrittenFile
from urdfctl.migrate.trial.trials import Trials
from urdfctl.output.change import Change, bytes_of
from urdfctl.source.disk.gate import is_file
from urdfctl.source.span import SourceText
from urdfctl.source.todo import todos_in
from urdfctl.startup.records import NamedTuple

MOST_PASSES = 3
_MOST_STATES = 4
"""So many states of a robot are remembered: an attempt reads again most of what the last one read."""
MENDING = ("installed-files", "fixes-of-lint")
"""The names of the last steps, which mend what lint finds after the others."""
_UNREADABLE = ("UC001", "UC024", "UC026", "UC027")
"""The findings about files that are no valid XML, YAML or Python, in which no step can change anything."""


class Migration(NamedTuple):
    """The result of a migration; nothing is written yet.

    changes: the files to change, create or delete.
    lines: the report.
    steps: the same changes by the steps that make them, in order.
    """

    changes: tuple[Change, ...]
    lines: tuple[ReportLine, ...]
    steps: tuple[tuple[str, tuple[Change, ...]], ...] = ()


def migrate(
    scratch: Scratch, options: MigrationOptions, settings: Settings, lint: Lint, steps: Sequence[Step]
) -> Migration:
    """Return the migration of the packages in a copy.

    The steps are applied in order, then the whole is judged. If there are objections, the step that is responsible is
    left out in the files concerned, and all is done again. As a second run would begin with the result of that, all is
    repeated from there until nothing changes.

    settings: without a distro.
    """
    source = lint(settings._replace(distro=options.source))
    first, known = source, Memory[LoadedTarget](scratch, _MOST_STATES, by_package=True)
    came_from = origins(options, first, scratch)
    check_direction(options.target, came_from)
    noted: Sequence[Noted] = ()
    left_out: dict[Key, str] = {}
    robots: Sequence[LoadedTarget] = ()
    states: list[tuple[str, Mapping[str, WrittenFile]]] = []
    for _ in range(MOST_PASSES):
        target = lint(settings._replace(distro=options.target))
        packages = MigratedPackages(
            scratch, options, settings, linted=source, known=known, began=first, origins=came_from
        )
        robots = packages.robots_before = robots or packages.loaded()
        wanted = [step for step in steps if _is_wanted(step, packages)]
        state = before(source, target, packages.loaded())
        if not options.only:
            mending = _mending(lint, settings._replace(distro=options.target), first, state)
            wanted += [step for step in mending if options.takes(step.name, step.part)]
        trials = Trials(packages, wanted, state, lint=lint, settings=settings, earlier=noted)
        attempt, found = trials.best()
        states += trials.states()
        noted = attempt.noted
        left_out = {**{key: why for key, why in left_out.items() if key not in attempt.touched}, **attempt.barred}
        if not attempt.barred or not attempt.touched:
            break
        source = lint(settings._replace(distro=options.source))  # what was left out may be possible now
    changes = scratch.changes()
    lines = [*_done(scratch, noted)]
    if changes or left_out:
        lines += [*_not_done(scratch, left_out, found), *_left(scratch, first, attempt, found)]
    from_ros1 = options.source in ROS1 or any(result.ros == 1 for _, result in first)
    lines += inventory(scratch, options, changes, from_ros1=from_ros1)
    return Migration(changes, tuple(lines), tuple(_by_step(scratch, states)))


def _by_step(
    scratch: Scratch, states: Sequence[tuple[str, Mapping[str, WrittenFile]]]
) -> Iterator[tuple[str, tuple[Change, ...]]]:
    """Yield the steps that changed anything, each with its changes."""
    last: Mapping[str, WrittenFile] = {}
    for name, state in states:
        if changes := scratch.changes_between(last, state):
            yield name, changes
        last = state


def _done(scratch: Scratch, noted: Iterable[Noted]) -> Iterator[ReportLine]:
    """Yield the report's lines on what was applied, with real paths and the lines of the migrated files."""
    todos: dict[str, list[tuple[str, int]]] = {}
    for one in noted:
        entry, file = one.entry, scratch.real(one.file) if one.file else ""
        line = 0
        if is_file(one.file):
            own = todos.setdefault(one.file, _todos(one.file))
            line = _line(one.file, one.offset) if entry.at else 0
            todo = _taken(own, entry.message) if entry.kind is EntryKind.FOR_YOU else 0
            line = line if todo in (0, line - 1) else todo  # the TODO is above it, or in a text that was written anew
        message, more = scratch.shown(entry.message), (entry.authority, entry.option)
        yield ReportLine(entry.kind, message, one.step, file, line, *more)


def _line(path: str, offset: int) -> int:
    return (bytes_of(path) or b"")[:offset].count(b"\n") + 1


def _todos(path: str) -> list[tuple[str, int]]:
    """The texts of the TODOs in a file, with their lines."""
    source = SourceText(path, bytes_of(path) or b"")
    return [(text, source.position(place.span.start).line) for text, place in todos_in(source)]


def _taken(todos: list[tuple[str, int]], message: str) -> int:
    """The line of the first TODO with a text, which is not taken again; 0 if there is none."""
    found = next((todo for todo in todos if _plain(todo[0]) == _plain(message)), None)
    if found is None:
        return 0
    todos.remove(found)
    return found[1]


def _plain(text: str) -> bytes:
    return without_punctuation(text.encode("utf-8", "replace"))


def _not_done(scratch: Scratch, left_out: Mapping[Key, str], found: Iterable[Objection]) -> Iterator[ReportLine]:
    """Yield the report's lines on what was left out, and the objections that no step is responsible for."""
    for (step, file), why in left_out.items():
        message = scratch.shown(f"{NOT_CHANGED} '{step}': {why}")
        yield ReportLine(EntryKind.FOR_YOU, message, step, scratch.real(file))
    for objection in found:
        if objection.finding is None:
            yield ReportLine(EntryKind.FOR_YOU, scratch.shown(objection.message), file=scratch.real(objection.file))


def _left(scratch: Scratch, source: Linted, attempt: Attempt, found: Iterable[Objection]) -> Iterator[ReportLine]:
    """Yield a line for each error that lint finds for the target, and did not find for the distro to migrate from; and
    for each warning of a new kind that leaving out a step would only turn into errors.

    Equal ones of a file are one line. The files that cannot be read are listed too.
    """
    known, errors = _errors(source), _errors(attempt.linted)
    warnings = {_identity(one.finding): one.finding for one in found if one.finding and one.is_warning}
    new = [finding for key, finding in (errors | warnings).items() if key not in known and scratch.has(finding.at.file)]
    for finding in grouped(new):
        message = scratch.shown(f"lint finds {finding.code}: {finding.message}")
        yield ReportLine(EntryKind.FOR_YOU, message, "", scratch.real(finding.at.file), finding.at.line)
    unread = (one for key, one in errors.items() if key in known and one.code in _UNREADABLE)
    for finding in grouped([one for one in unread if scratch.has(one.at.file)]):
        message = f"{NOT_READ}, because it cannot be read ({finding.code}: {finding.message})"
        yield ReportLine(EntryKind.FOR_YOU, message, "", scratch.real(finding.at.file), finding.at.line)


def _errors(linted: Linted) -> dict[tuple[str, str, str], Diagnostic]:
    """The errors, by what identifies them although their lines move."""
    found = (finding for _, result in linted for finding in result.outcome.diagnostics)
    return {_identity(one): one for one in found if one.severity is Severity.ERROR}


def _identity(finding: Diagnostic) -> tuple[str, str, str]:
    return finding.code, finding.at.file, finding.message


def _mending(lint: Lint, settings: Settings, source: Linted, state: Before) -> list[Step]:
    """The steps for what lint finds for the target, of the findings that would be objections, or left."""
    known = _errors(source)

    def is_new(finding: Diagnostic) -> bool:
        is_error = finding.severity is Severity.ERROR and _identity(finding) not in known
        return is_error or (finding.severity is not Severity.INFO and finding.code not in state.codes)

    return [make(lambda: lint(settings), is_new) for make in (installs_for_launch_files, fixes_of_lint)]


def _is_wanted(step: Step, packages: MigratedPackages) -> bool:
    return packages.options.takes(step.name, step.part) and (step.generation != 1 or packages.is_ros1)
