"""Lint the robots of a lint command, and the files in their folders that no robot uses."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence

from urdfctl.config.robots import ConfiguredRobot
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.lint.planning import (
    Arguments,
    Origin,
    PlannedTarget,
    is_launched_already,
    of_shard,
    planned,
    with_bringups,
)
from urdfctl.lint.results import TargetResult
from urdfctl.lint.unstarted import as_started
from urdfctl.load.target import Target
from urdfctl.source.files import is_launch
from urdfctl.startup.hints import TYPE_CHECKING
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from typing import Protocol

    from urdfctl.discover.shards import Shard

    class TargetLinter(Protocol):
        """Lints targets: in limited workers for a command, in this process for an editor."""

        def lint(self, targets: Sequence[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[TargetResult]:
            """Yield the result of each target, in order. focus: as in `lint_target`, for each target."""

        def variants(self, targets: Sequence[Target]) -> list[list[Target]]:
            """Return, for each launch file, a target for each choice of the arguments that it needs."""


LintedTargets = list[tuple[Target, TargetResult]]
LintTargets = Callable[[list[Target]], Iterator[tuple[Target, TargetResult]]]
LintPlanned = Callable[[list[PlannedTarget]], Iterator[tuple[Target, TargetResult]]]
LaunchedTargets = list[tuple[PlannedTarget, tuple[Target, TargetResult]]]


class LintRun(NamedTuple):
    """The results of a run.

    robots: the results of robots.
    targets: all targets with their results, also macro libraries, fragments and files not used by any robot.
    silent: the results of launch files that start a robot without controllers, and have no findings of their own.
    """

    robots: list[TargetResult]
    targets: LintedTargets
    silent: tuple[TargetResult, ...] = ()

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


def lint_files(
    files: DiscoveredFiles,
    arguments: Arguments,
    linter: TargetLinter,
    robots: Sequence[ConfiguredRobot] = (),
    shard: Shard | None = None,
) -> LintRun:
    """Lint the robots among some files, then the files that none of them uses.

    robots: those of the configuration. shard: the share of the files to lint; all if None.
    """

    def linted(targets: list[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[tuple[Target, TargetResult]]:
        return zip(targets, linter.lint(targets, focus), strict=True)

    def linted_launches(entries: list[PlannedTarget]) -> Iterator[tuple[Target, TargetResult]]:
        return linted([entry.target for entry in entries], [entry.must_read for entry in entries])

    plan = planned(files, arguments, robots)
    if shard is not None:
        files, plan = of_shard(files, plan, shard, robots)
    launch_files = [entry for entry in plan if entry.is_launched]
    started = _launched(launch_files, linted_launches, linter)
    launched = [(entry, pair) for entry, pair in started if entry.is_reported(pair[1])]
    silent = tuple(
        result
        for entry, (_, result) in started
        if entry.origin is Origin.LAUNCHED and not entry.is_reported(result) and not is_launch(result.path)
    )
    known = {(result.path, result.arguments) for _, (_, result) in launched if result.controllers}
    plan = [entry for entry in plan if not entry.is_launched and not is_launched_already(entry, known)]
    plan = with_bringups(plan, [(entry, result) for entry, (_, result) in launched])
    again = {entry.target.launch and os.path.abspath(entry.target.launch) for entry in plan}
    launched = [one for one in launched if one[1][1].launch not in again]
    results = zip(linted([entry.target for entry in plan]), plan, strict=True)
    starts = [result for _, (_, result) in started if result.launch]
    reported = [
        (target, as_started(entry, result, starts)) for (target, result), entry in results if entry.is_reported(result)
    ]
    reported += [pair for _, pair in launched]
    reported += linted(_unread(files.controllers, reported))
    reported = _paired(reported, _unread(files.controllers_candidates, reported), linted)
    unused = [Target(path, fragment=True) for path in files.unread(_files_read(reported))]
    unused += _unread(files.controllers_candidates, reported)
    launch_paths = {os.path.abspath(path) for path in (*files.launch_candidates, *files.around)}
    linted_robots = [result for _, result in reported if result.path not in launch_paths]
    return _without_generated(LintRun(linted_robots, [*reported, *linted(unused)], silent), files)


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


def _launched(entries: list[PlannedTarget], linted: LintPlanned, linter: TargetLinter) -> LaunchedTargets:
    """The results of launch files: with each choice of the arguments that they need, with each of their robots, and
    of included launch files that could not be followed."""
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
            more += [entry._replace(target=Target(path, launch=result.launch)) for path in bringup.others]
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
    from urdfctl.lint.elimination import pairs_by_elimination

    pairs = dict(pairs_by_elimination(reported, [target.path for target in unused]))
    again = dict(zip(pairs, linted(list(pairs.values())), strict=True))
    return [again.get(target, (target, result)) for target, result in reported]


def _files_read(targets: LintedTargets) -> set[str]:
    return {file for _, result in targets for file in result.files}


def _unread(paths: list[str], targets: LintedTargets) -> list[Target]:
    """Return the files that were not read for any target."""
    read = _files_read(targets)
    return [Target(path) for path in paths if os.path.abspath(path) not in read]
