"""A smoke run in stages, as `smoke` calls them: find, plan, load, judge, move, report.

A robot is loaded and judged in one limited worker, and moved in another, fresh one for each engine.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import partial
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from urdfctl.config.file import Config
from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.discover.beside import controllers_beside, starts_beside
from urdfctl.discover.robots import DiscoveredFiles
from urdfctl.errors import UserError
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.findings.weakening import is_with_defaults
from urdfctl.lint.job import Work, Workers, failed, launch_variants, run_on_targets, shared_loader
from urdfctl.lint.planning import Arguments, PlannedTarget, discovered, of_shard, planned
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import LintedTarget, lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.meshes import mesh_path
from urdfctl.load.target import Target
from urdfctl.names import enumerated
from urdfctl.report.common import shown
from urdfctl.run.limits import processors
from urdfctl.smoke.aside import as_aside
from urdfctl.smoke.checked_robot import CheckedRobot
from urdfctl.smoke.choices import choices_of
from urdfctl.smoke.pairing import with_joined
from urdfctl.smoke.ranking import causes_first
from urdfctl.smoke.reports import SmokeReport, report_of
from urdfctl.smoke.results import RobotResult
from urdfctl.smoke.statics import check_statically, with_mock_hardware
from urdfctl.smoke.tasks import MOTION, TaskFile, misfits
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from urdfctl.discover.shards import Shard


class SmokeRequest(NamedTuple):
    """The request of a smoke run: what it tests, and how.

    only: the names of the controllers to test; none for all.
    engines: each of them moves the robots; without any, nothing moves.
    instead: the engines that are tried if an engine crashes or rejects a robot.
    duration: the time for which each controller moves, in s.
    gui: whether to show a window.
    live: whether to print a line on standard error for each controller as soon as it was moved.
    tasks: the user's own tasks as plain data (see `TaskFile`), or None.
    arguments: given to each description, as names with values.
    controllers: files that each robot reads besides its own.
    mocked: whether mock hardware is taken in the place of a driver that cannot be started, or is not in the files.
    shard: the share of the targets to test; all if None.
    parallel: how many workers run at the same time; one for each processor if None.
    """

    only: tuple[str, ...] = ()
    engines: tuple[str, ...] = ()
    instead: tuple[str, ...] = ()
    duration: float = MOTION
    gui: bool = False
    live: bool = False
    tasks: Any = None
    arguments: Arguments = ()
    controllers: tuple[str, ...] = ()
    mocked: bool = False
    shard: Shard | None = None
    parallel: int | None = None


class ConfiguredPaths(NamedTuple):
    """Paths that are tested with one configuration, as a rule the one around them."""

    paths: tuple[str, ...]
    config: Config
    settings: Settings


class PlannedRobot(NamedTuple):
    """A target of a run, with the settings of its group."""

    entry: PlannedTarget
    settings: Settings

    @property
    def target(self) -> Target:
        """The target, which is loaded."""
        return self.entry.target


class RobotTest(NamedTuple):
    """The result of one target of a run, with the settings of its group."""

    target: Target
    settings: Settings
    result: RobotResult


def smoke(
    groups: Sequence[ConfiguredPaths],
    request: SmokeRequest,
    watch: Callable[[Iterator[RobotTest], int], Iterable[RobotTest]] = lambda tests, _: tests,
) -> list[RobotTest]:
    """Return the tests of the robots that some paths mean; `report` makes a report of them.

    watch: is given the tests as they come, with their greatest number, and gives them back.
    Raises UserError if there is nothing to test, or if the request names what no robot has.
    """
    robots = [robot for group in groups for robot in plan(find(group), group, request)]
    if not robots and request.shard is None:
        where = ", ".join(path for group in groups for path in group.paths) or "this folder"
        raise UserError(f"nothing to test in {where}: name a robot or a launch file")
    tests = list(watch(_tested(robots, request), len(robots)))
    _check_only(request.only, [test.result for test in tests])
    return tests


def _tested(robots: Sequence[PlannedRobot], request: SmokeRequest) -> Iterator[RobotTest]:
    robots, checked = _with_choices(robots, _check(robots, request), request)
    reported = list(_reported(robots, [robot.result for robot in checked]))
    limits = robots[0].settings if robots else Settings()  # the options of the run, which are the same for all
    results = move([checked[index] for index in reported], request, limits)
    for index, result in zip(reported, results, strict=True):
        robot = robots[index]
        yield RobotTest(robot.target, robot.settings, as_aside(robot.entry, result))


def _check(robots: Sequence[PlannedRobot], request: SmokeRequest) -> list[CheckedRobot]:
    return check([robot.target for robot in robots], [robot.settings for robot in robots], request)


def _with_choices(
    robots: Sequence[PlannedRobot], checked: Sequence[CheckedRobot], request: SmokeRequest
) -> tuple[list[PlannedRobot], list[CheckedRobot]]:
    """The robots with their checks, where launch files that need arguments are started with some that exist."""
    settings = robots[0].settings if robots else Settings()

    def variants(targets: list[Target]) -> list[list[Target]]:
        return launch_variants(targets, settings, Workers(Loader(settings), request.parallel or processors()))

    choices = choices_of([robot.target for robot in robots], [one.result.linted for one in checked], variants)
    kept = [(robot, one) for n, (robot, one) in enumerate(zip(robots, checked, strict=True)) if n not in choices]
    more = [
        robots[n]._replace(
            entry=robots[n].entry._replace(target=target._replace(controllers=robots[n].target.controllers))
        )
        for n, targets in choices.items()
        for target in targets
    ]
    kept += zip(more, _check(more, request) if more else (), strict=True)
    return [robot for robot, _ in kept], [one for _, one in kept]


# -- find and plan ---------------------------------------------------------------------------------------------------


def find(group: ConfiguredPaths) -> DiscoveredFiles:
    """Return the files that the paths of a group mean."""
    return discovered(group.paths, group.config)


def plan(files: DiscoveredFiles, group: ConfiguredPaths, request: SmokeRequest) -> list[PlannedRobot]:
    """Return the targets that some files of a group are."""
    entries = planned(files, request.arguments, group.config.robots)
    if request.shard is not None:
        _, entries = of_shard(files, entries, request.shard, group.config.robots)
    targets = (each.target._replace(controllers=(*each.target.controllers, *request.controllers)) for each in entries)
    return [
        PlannedRobot(entry._replace(target=target), group.settings)
        for entry, target in zip(entries, targets, strict=True)
    ]


# -- load and judge, in the first worker -----------------------------------------------------------------------------


def check(targets: Sequence[Target], settings: Sequence[Settings], request: SmokeRequest) -> list[CheckedRobot]:
    """Return targets, each loaded with its own settings and judged without an engine.

    A launch file that spawns controllers without a robot has the only start beside which it may be started.
    Raises UserError, with file and line, if the user's tasks do not fit a robot, or name what no robot has.
    """
    if request.engines:
        import urdfctl.smoke.robot_motion  # noqa: F401 (for all workers at once, before they fork)
    robots = list(_checked(targets, settings, request))
    of_path = {os.path.abspath(target.path): its for target, its in zip(targets, settings, strict=True)}

    def check_more(more: list[Target]) -> Iterator[CheckedRobot]:
        return _checked(more, [of_path[os.path.abspath(target.path)] for target in more], request)

    robots = with_joined(targets, robots, check_more)
    _check_tasks(robots, request)
    return robots


def _checked(targets: Sequence[Target], settings: Sequence[Settings], request: SmokeRequest) -> Iterator[CheckedRobot]:
    for its_settings, pairs in groupby(zip(settings, targets, strict=True), key=itemgetter(0)):
        group = [target for _, target in pairs]
        results = run_on_targets(
            load_and_judge,
            group,
            its_settings,
            details=[request._asdict()] * len(group),
            workers=Workers(shared_loader(group, its_settings), request.parallel or processors()),
        )
        for target, result in zip(group, results, strict=True):
            if isinstance(result, dict):
                yield CheckedRobot.from_json(result)
            else:
                yield CheckedRobot(RobotResult(failed(target, its_settings, result)), None)


def load_and_judge(work: Work) -> dict[str, Any]:
    """Return the checked robot of a job, in a worker."""
    seen = load(work.loader, work.target)
    return judge(seen, work.loader, SmokeRequest(**work.details), guessed=work.target.guessed).to_json()


def load(loader: Loader, target: Target) -> LintedTarget:
    """Return a target with its files and the findings of all rules."""
    return lint_target(loader, target, Selection())


def judge(seen: LintedTarget, loader: Loader, request: SmokeRequest, *, guessed: bool = False) -> CheckedRobot:
    """Return a robot after the checks without an engine, with the plan for an engine if one is wanted.

    guessed: whether the arguments of its launch file are guessed.
    """
    packages = loader.reading(seen.result.path)[1]
    given = TaskFile.from_json(request.tasks) if request.tasks else None
    find_mesh = partial(mesh_path, packages=packages, robot_file=seen.result.path)
    mocked = with_mock_hardware(seen) if request.mocked else None
    static_check = check_statically(mocked or seen, request.only, find_mesh, given)
    static_check = static_check._replace(mocked=mocked is not None, guessed=guessed)
    motion_plan = None
    if request.engines:
        from urdfctl.smoke.robot_motion import plan_of

        motion_plan, troubles = plan_of(static_check, packages, request.duration, gui=request.gui)
        static_check = static_check._replace(troubles=(*static_check.troubles, *troubles))
    mechanism = static_check.mechanism
    names = [controller.name for controller in static_check.lifecycle.controllers]
    robot = CheckedRobot(
        result=static_check.result,
        plan=motion_plan,
        misfits=tuple(misfits(given, mechanism, static_check.tasks, names)) if given and mechanism else (),
    )
    if motion_plan is None:
        return robot
    return robot._replace(
        placed=static_check.placed(),
        troubles=static_check.troubles,
        suppressed=static_check.suppressed_codes(),
        not_started=static_check.not_started,
        doubts=static_check.doubts,
    )


def _check_tasks(robots: Sequence[CheckedRobot], request: SmokeRequest) -> None:
    """Reject tasks that do not fit a robot, or that name what no robot has. UserError with file and line."""
    if not request.tasks:
        return
    file = TaskFile.from_json(request.tasks)
    found = [misfit for robot in robots for misfit in robot.misfits]
    tasked = sum(robot.plan is not None for robot in robots)
    for misfit in sorted(found):
        if not misfit.absent or found.count(misfit) >= tasked:
            raise UserError(f"{shown(file.path)}:{misfit.line}: {misfit.message}")


def _reported(robots: Sequence[PlannedRobot], results: Sequence[RobotResult]) -> Iterator[int]:
    """Yield the indices of the results to report. Each robot with its controllers is reported once, in whatever order
    launch files start them, unless they are rejected for another reason then. A description in a folder is not reported
    as it is if launch files start it with controllers, with another outcome; a robot without controllers only if no
    launch file gives it any. If nothing has controllers, launch files that include what is not here are reported too,
    each set of missing packages once."""
    among = [
        robot if planned_robot.entry.is_reported(robot.linted) else None
        for planned_robot, robot in zip(robots, results, strict=True)
    ]
    driven = {robot.linted.path for robot in among if robot and robot.controllers}
    launched = [robot for robot in among if robot and robot.controllers and robot.linted.launch]
    outcomes, started = set(map(_outcome, launched)), {robot.linted.path for robot in launched}
    seen = set()
    for index, robot in enumerate(among):
        if robot is None:
            continue
        outcome, path = _outcome(robot), robot.linted.path
        is_bare = not robot.linted.launch and is_with_defaults(robots[index].entry)
        if is_bare and path in started and outcome not in outcomes:
            continue
        if outcome not in seen and (robot.controllers or path not in driven):
            seen.add(outcome)
            yield index
    if not driven:
        told = {robot.needs for robot in among if robot}
        for index, robot in enumerate(results):
            if robot.needs and robot.needs not in told and among[index] is None and robot.linted.launch:
                told.add(robot.needs)
                yield index


def _outcome(robot: RobotResult) -> tuple[object, ...]:
    """A robot with its controller files, and what comes of each controller."""
    verdicts = frozenset((result.name, result.verdict, result.reason) for result in robot.controllers)
    return robot.linted.path, robot.linted.controllers, verdicts


# -- move, in an engine's worker -------------------------------------------------------------------------------------


def move(robots: Sequence[CheckedRobot], request: SmokeRequest, limits: Settings) -> Iterator[RobotResult]:
    """Yield the result of each robot after all engines of the request have moved it.

    limits: the settings that limit time and memory, the same for all.
    """
    runs = [(n, engine) for n, robot in enumerate(robots) if robot.plan for engine in request.engines]
    if not runs:
        yield from (robot.result for robot in robots)
        return
    from urdfctl.smoke.motion import EngineWorkers, compared
    from urdfctl.smoke.robot_motion import with_engine_result

    plans = [made.within(limits.timeout)._replace(engine=engine) for n, engine in runs if (made := robots[n].plan)]
    simulations = EngineWorkers(limits, request.parallel or processors(), request.instead, live=request.live)
    engine_results = iter(zip(runs, simulations.results(plans), strict=True))
    pending = next(engine_results, None)
    for n, robot in enumerate(robots):
        result, trials = robot.result, []
        while pending and pending[0][0] == n:
            trials.append(pending[1])
            pending = next(engine_results, None)
        for engine, trial in compared(trials):
            result = with_engine_result(result, robot, engine, trial)
        yield result._replace(interrupted=simulations.interrupted)


def _check_only(only: Sequence[str], results: Sequence[RobotResult]) -> None:
    names = {controller.name for robot in results for controller in robot.controllers}
    unknown = [name for name in only if name not in names]
    if unknown:
        quoted = enumerated([f"'{name}'" for name in unknown], "or")
        raise UserError(f"--only: no robot has a controller {quoted}")


# -- report ----------------------------------------------------------------------------------------------------------


def report(
    tests: Sequence[RobotTest],
    groups: Sequence[ConfiguredPaths],
    selection: Selection = Selection(),  # noqa: B008 (immutable)
    *,
    unknown: Callable[[list[Diagnostic], Collection[str]], list[Diagnostic]] | None = None,
    fail_on: Severity = Severity.ERROR,
) -> SmokeReport:
    """Return the report of a run: the findings of all its robots, merged and selected, and the results.

    A controller that fails for a finding that is not reported is warned instead.

    unknown: given the findings and the files that were read, returns the findings that no baseline has.
    fail_on: the severity from which findings fail the run.
    """
    results = [test.result for test in tests]
    everything = merge([robot.linted.outcome for robot in results], Selection())
    findings = [
        finding
        for finding in everything
        if selection.admits(finding.code)
        and not any(group.config.ignores(finding.at.file, finding.code) for group in groups)
    ]
    if unknown is not None:
        findings = unknown(findings, {file for robot in results for file in robot.linted.files})
    reported = {finding.message for finding in findings}
    hidden = [finding.message for finding in everything if finding.message not in reported]
    made = report_of([robot.without(hidden) for robot in results], causes_first(findings), fail_on)
    if not made.is_empty:
        return made
    robotless = [robot.linted.path for robot in results if robot.robotless and not robot.needs]
    return made._replace(unused=tuple(_unused_of(groups, results)), instead=tuple(starts_beside(robotless)))


def _unused_of(groups: Sequence[ConfiguredPaths], results: Sequence[RobotResult]) -> Iterable[str]:
    """The files in folders that look like controller files; of a run in which no robot has controllers.

    If there are none, those in the workspace that name joints of the only robot.
    """
    found = [path for group in groups for path in find(group).controllers_candidates]
    if not found and len(results) == 1:
        linted = results[0].linted
        found = controllers_beside(linted.launch or linted.path, linted.joining.joints)
    return map(os.path.normpath, found)
