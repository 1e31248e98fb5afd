"""A run of lint in stages, as `lint` calls them: find, plan, load and judge, merge, report.

A command and the language server run the same stages. Only what loads and judges differs: `InWorkers`, or `LiveLinter`
for open texts.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Protocol

from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.errors import UserError
from urdfctl.lint import merging, planning
from urdfctl.lint.elimination import pairs_by_elimination
from urdfctl.lint.grouping import grouped
from urdfctl.lint.job import launch_variants, lint_all
from urdfctl.lint.joining import Joined, is_lonely, joined, targets_near
from urdfctl.lint.planning import Arguments, PlannedTarget, TargetOrigin, is_launched_already, of_shard, with_bringups
from urdfctl.lint.results import Report, TargetResult
from urdfctl.lint.selection import Selection
from urdfctl.lint.weakening import as_started, as_unused, as_used
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.names import did_you_mean
from urdfctl.source.disk.files import is_launch
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.config.definitions import Nodes
    from urdfctl.discover.shards import Shard
    from urdfctl.lint.cache import RunCache

    class TargetLinter(Protocol):
        """Lints targets: in limited workers for a command, in this process for an editor."""

        def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
            """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""

        def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
            """Return, for each launch file, a target for each choice of the arguments that it needs."""


LintedTargets = list[tuple[Target, TargetResult]]
LintTargets = Callable[..., Iterator[tuple[Target, TargetResult]]]
"""Lints targets, given with their focus or without."""
LaunchedTargets = list[tuple[PlannedTarget, tuple[Target, TargetResult]]]


class LintRun(NamedTuple):
    """The results of a run.

    robots: the results of robots.
    targets: all targets with their results, also macro libraries, fragments and files not used by any robot.
    silent: the results of launch files that start a robot without controllers, and have no findings of their own.
    despite: files that were linted although COLCON_IGNORE or CATKIN_IGNORE excludes them: there is nothing else.
    """

    robots: list[TargetResult]
    targets: LintedTargets
    silent: tuple[TargetResult, ...] = ()
    despite: tuple[str, ...] = ()

    @property
    def unused(self) -> list[TargetResult]:
        """The results of what no robot uses."""
        used = {id(result) for result in self.robots}
        return [result for result in self.results if id(result) not in used]

    @property
    def results(self) -> list[TargetResult]:
        """Return the results of all targets."""
        return [result for _, result in self.targets]

    @property
    def crashed(self) -> bool:
        """Return whether urdfctl crashed on any target."""
        return any(result.outcome.crashed for result in self.results)


class LintRequest(NamedTuple):
    """What a run lints, and how.

    paths: files and folders; the package around the current folder if empty.
    selection: the rules.
    arguments: given to each description, as names with values.
    shard: the share of the files to lint; all if None.
    parallel: how many workers run at the same time; one for each processor if None.
    """

    paths: tuple[str, ...]
    config: Config
    settings: Settings
    selection: Selection = Selection()
    arguments: Arguments = ()
    shard: Shard | None = None
    parallel: int | None = None


class Plan(NamedTuple):
    """The targets of a run, and the files that they were planned from: more targets follow from what these start."""

    files: DiscoveredFiles
    targets: list[PlannedTarget]


Watch = Callable[[Iterator[TargetResult], int], Iterator[TargetResult]]
"""Is given results as they come, with their number, and gives them back."""


def unwatched(results: Iterator[TargetResult], _number: int) -> Iterator[TargetResult]:
    """Give results back as they are."""
    return results


def _nothing() -> None:
    return None


def lint(
    request: LintRequest,
    *,
    watch: Watch = unwatched,
    meanwhile: Callable[[], object] = _nothing,
    is_cached: bool = False,
) -> LintRun:
    """Return the results of what the paths of a request mean; `merge` and `report` make findings and a report of them.

    meanwhile: is called while the workers are busy.
    is_cached: results of an earlier run may be used, and those of this one stored.
    Raises UserError if there is nothing to lint.
    """
    cache = _cache(request) if is_cached else None
    stored = cache.load() if cache else None
    if stored is not None:
        results, positions = stored
        run = LintRun([result for index, (_, result) in enumerate(results) if index in positions], results)
    else:
        run = _linted(request, watch, meanwhile)
    if cache and stored is None:
        robots = {id(result) for result in run.robots}
        cache.store(run.targets, (index for index, (_, result) in enumerate(run.targets) if id(result) in robots))
    if request.settings.nodes:
        _check_nodes(request.settings.nodes, run.results)
    return run


def _cache(request: LintRequest) -> RunCache:
    from urdfctl.lint.cache import RunCache

    asked = request._replace(settings=Settings(), parallel=None)
    file = request.config.file
    return RunCache(request.paths, request.settings, asked, extra=[file] if file else ())


def _linted(request: LintRequest, watch: Watch, meanwhile: Callable[[], object]) -> LintRun:
    where = ", ".join(request.paths) or "this folder"
    files = find(request)
    if not files.paths():
        raise UserError(
            f"nothing to lint in {where}: name a robot (.urdf, .xacro), a controller file (.yaml) or a launch file, or "
            "a folder that contains one"
        )
    run = judge(plan(files, request), in_workers(request, watch, meanwhile))
    if not run.results and request.shard is None:
        raise UserError(
            f"nothing to lint in {where}: it contains launch files, but they start no robot or controllers of this "
            "workspace"
        )
    return run


def _check_nodes(nodes: Nodes, results: Sequence[TargetResult]) -> None:
    """UserError if no file has parameters for a node: nothing would have been checked."""
    checked = {name for result in results for name in result.nodes}
    there = {name for result in results for name in result.sections}
    for name, _ in nodes:
        if name not in checked:
            raise UserError(f"--node {name}: no file has parameters for a node of this name{did_you_mean(name, there)}")


# -- find and plan ---------------------------------------------------------------------------------------------------


def find(request: LintRequest) -> DiscoveredFiles:
    """Return the files that the paths of a request mean. UserError says what is wrong with a path."""
    return planning.discovered(request.paths, request.config)


def plan(files: DiscoveredFiles, request: LintRequest) -> Plan:
    """Return the targets that some files are at first sight."""
    robots = request.config.robots
    targets = planning.planned(files, request.arguments, robots)
    return Plan(files, targets) if request.shard is None else Plan(*of_shard(files, targets, request.shard, robots))


# -- load and judge, in workers --------------------------------------------------------------------------------------


class InWorkers(NamedTuple):
    """Loads targets and runs the rules on them, in limited workers."""

    request: LintRequest
    loader: Loader
    watch: Watch
    meanwhile: Callable[[], object]

    def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
        """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""
        results = lint_all(
            targets,
            self.request.settings,
            self.request.selection,
            focus=focus,
            loader=self.loader,
            parallel=self.request.parallel,
            meanwhile=self.meanwhile,
        )
        return self.watch(results, len(targets))

    def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
        """Return, for each launch file, a target for each choice of the arguments that it needs."""
        return launch_variants(targets, self.request.settings, self.loader, self.request.parallel)


def in_workers(request: LintRequest, watch: Watch = unwatched, meanwhile: Callable[[], object] = _nothing) -> InWorkers:
    """Return what lints the targets of a request. watch, meanwhile: as in `lint`."""
    return InWorkers(request, Loader(request.settings), watch, meanwhile)


def judge(plan: Plan, linter: TargetLinter) -> LintRun:
    """Return the results of a plan: of its launch files first, because they say what belongs to each robot, then of
    the other robots, then of the files that none of them uses."""

    def linted(targets: list[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[tuple[Target, TargetResult]]:
        return zip(targets, linter.lint(targets, focus), strict=True)

    files = plan.files
    started = _launched([entry for entry in plan.targets if entry.is_launched], linted, linter)
    launched = [(entry, pair) for entry, pair in started if entry.is_reported(pair[1])]
    silent = [result for entry, (_, result) in started if _is_silent(entry, result)]
    entries = _not_launched(plan.targets, launched)
    again = {entry.target.launch and os.path.abspath(entry.target.launch) for entry in entries}
    results = zip(linted([entry.target for entry in entries]), entries, strict=True)
    starts = [result for _, (_, result) in started if result.launch]
    reported = [
        (target, as_started(entry, result, starts)) for (target, result), entry in results if entry.is_reported(result)
    ]
    reported += [pair for _, pair in launched if pair[1].launch not in again]
    together = _together(started, reported, linted)
    covered = {(result.path, result.arguments) for _, result in together.results}
    reported = [
        *together.results,
        *(
            pair
            for pair in reported
            if id(pair[1]) not in together.replaced and not (_is_alone(pair) and _key(pair[1]) in covered)
        ),
    ]
    silent = [result for result in silent if id(result) not in together.replaced]
    reported += linted(_unread(files.controllers, reported))
    reported = _paired(reported, _unread(files.controllers_candidates, reported), linted)
    unused = [Target(path, fragment=True) for path in files.unread(_files_read(reported))]
    unused += _unread(files.controllers_candidates, reported)
    reported = as_used(reported, _named(files), starts)
    launch_paths = {os.path.abspath(path) for path in (*files.launch_candidates, *files.around)}
    robots = [result for _, result in reported if result.path not in launch_paths]
    run = LintRun(robots, [*reported, *as_unused(linted(unused))], tuple(silent), tuple(files.despite))
    return _without_generated(run, files)


def _together(started: LaunchedTargets, reported: LintedTargets, linted: LintTargets) -> Joined:
    """What is started beside each other: launch files without a robot, with those that start one."""
    wanted = {id(result) for entry, (_, result) in started if entry.origin is not TargetOrigin.AROUND}
    wanted |= {id(result) for _, result in reported}
    launched = [pair for _, pair in started]
    known = {id(result) for _, result in launched}
    named = [target.path for target, result in reported if is_lonely(result) and id(result) not in known]
    near = list(dict.fromkeys(target for path in named for target in targets_near(path)))
    return joined([*launched, *reported, *(linted(near) if near else ())], wanted, linted)


def _named(files: DiscoveredFiles) -> set[str]:
    """The paths of the files that the user names."""
    return {os.path.abspath(path) for path in (*files.robots, *files.controllers, *files.launches)}


def _is_alone(pair: tuple[Target, TargetResult]) -> bool:
    """Whether a target is a description that nobody says anything else about."""
    return not is_launch(pair[0].path) and not pair[0].controllers and not pair[0].launch


def _key(result: TargetResult) -> tuple[str, Arguments]:
    return result.path, result.arguments


def _is_silent(entry: PlannedTarget, result: TargetResult) -> bool:
    """Whether a launch file in a folder starts a robot, and is not worth mentioning."""
    return entry.origin is TargetOrigin.LAUNCHED and not entry.is_reported(result) and not is_launch(result.path)


def _not_launched(plan: Sequence[PlannedTarget], launched: LaunchedTargets) -> list[PlannedTarget]:
    """The targets of a plan that are left when its launch files are linted, with what these say of them."""
    known = {(result.path, result.arguments) for _, (_, result) in launched if result.is_controlled}
    left = [entry for entry in plan if not entry.is_launched and not is_launched_already(entry, known)]
    return with_bringups(left, [(entry, result) for entry, (_, result) in launched])


def _without_generated(run: LintRun, files: DiscoveredFiles) -> LintRun:
    """The run without the findings in what xacro wrote from a linted file; except in files that the user names."""
    from urdfctl.lint.generated import equal_to_xacro, without_findings_in

    generated = {*map(os.path.abspath, files.generated), *equal_to_xacro(run.results)}
    generated -= set(map(os.path.abspath, files.robots))
    if not generated:
        return run
    known = {id(result) for result in run.robots}
    targets = [(target, without_findings_in(result, generated)) for target, result in run.targets]
    pairs = zip(run.targets, targets, strict=True)
    return run._replace(robots=[new for (_, old), (_, new) in pairs if id(old) in known], targets=targets)


def _launched(entries: list[PlannedTarget], lint_targets: LintTargets, linter: TargetLinter) -> LaunchedTargets:
    """The results of launch files: with each choice of the arguments that they need, with each of their robots, and
    of included launch files that could not be followed."""

    def linted(entries: list[PlannedTarget]) -> Iterator[tuple[Target, TargetResult]]:
        return lint_targets([entry.target for entry in entries], [entry.must_read for entry in entries])

    results = list(zip(entries, linted(entries), strict=True))
    known = {os.path.abspath(entry.target.path) for entry in entries}
    needy = [entry for entry, (_, result) in results if _lacks_robot(result) and not entry.target.launch]
    choices = linter.variants([entry.target for entry in needy]) if needy else []
    more: list[PlannedTarget] = []
    replaced: set[Target] = set()
    for entry, targets in zip(needy, choices, strict=True):
        if any(target.guessed for target in targets):
            more += [entry._replace(target=target) for target in targets]
            replaced.add(entry.target)
    for entry, (_, result) in results:
        bringup = result.bringup
        if bringup is not None:
            more += [
                entry._replace(target=Target(path, launch=result.launch, namespace=namespace))
                for path, namespace in bringup.others
            ]
            inner = [path for path in bringup.unfollowed if os.path.abspath(path) not in known]
            known.update(map(os.path.abspath, inner))
            more += [entry._replace(target=Target(path)) for path in inner]
    kept = [(entry, pair) for entry, pair in results if entry.target not in replaced]
    return [*kept, *zip(more, linted(more), strict=True)]


def _lacks_robot(result: TargetResult) -> bool:
    """Whether a launch file does not say which robot it starts, or the robot is unknown without more arguments."""
    return is_launch(result.path) or (result.links == 0 and not result.complete)


def _paired(
    reported: LintedTargets,
    unused: Sequence[Target],
    linted: LintTargets,
) -> LintedTargets:
    """The targets, with the only robot and the only controller file of a package together."""
    if not unused:
        return reported
    pairs = dict(pairs_by_elimination(reported, [target.path for target in unused]))
    again = dict(zip(pairs, linted(list(pairs.values())), strict=True))
    return [again.get(target, (target, result)) for target, result in reported]


def _files_read(targets: LintedTargets) -> set[str]:
    return {file for _, result in targets for file in result.files}


def _unread(paths: list[str], targets: LintedTargets) -> list[Target]:
    """Return the files that were not read for any target."""
    read = _files_read(targets)
    return [Target(path) for path in paths if os.path.abspath(path) not in read]


# -- merge and report ------------------------------------------------------------------------------------------------


def merge(results: Iterable[TargetResult], request: LintRequest) -> list[Diagnostic]:
    """Return the findings of all targets, each fault once, without those that per-file-ignores hides."""
    findings = merging.merge(merging.outcomes_of(results), request.selection)
    return [finding for finding in findings if not request.config.ignores(finding.at.file, finding.code)]


def report(
    run: LintRun,
    request: LintRequest,
    *,
    fail_on: Severity = Severity.ERROR,
    unknown: Callable[[list[Diagnostic], Collection[str]], list[Diagnostic]] | None = None,
) -> Report:
    """Return the report of a run: its findings, merged and grouped, and what was linted.

    fail_on: the severity from which findings fail the run.
    unknown: given the findings and the files that were read, returns the findings that no baseline has.
    """
    findings = merge(run.results, request)
    left = findings
    if unknown is not None:
        left = unknown(findings, {file for result in run.results for file in result.files})
    return Report(
        targets=tuple(run.robots),
        findings=tuple(grouped(left)),
        unused=tuple(result.path for result in run.unused),
        fail_on=fail_on,
        known=len(findings) - len(left),
        missing_packages=tuple(sorted({name for result in run.results for name in result.missing_packages})),
        uncontrolled=_uncontrolled(run.robots),
    )


def _uncontrolled(robots: Sequence[TargetResult]) -> str:
    """The path of the first robot if nothing of any robot is controlled."""
    whole = [result for result in robots if result.links]
    return whole[0].path if whole and all(result.idle for result in whole) else ""
