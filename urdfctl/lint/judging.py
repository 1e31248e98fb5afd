"""Load the targets of a plan and judge them together: launch files first, because they say what belongs to each robot,
then the other robots, then what none of them uses."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from urdfctl.discover.backups import is_backup
from urdfctl.discover.launch_files import takes_arguments
from urdfctl.discover.robots import DiscoveredFiles, included_from
from urdfctl.lint.chosen import chosen_starts, documented_starts
from urdfctl.lint.findings.weakening import as_started, as_unused, as_used
from urdfctl.lint.joining import Joined, is_lonely, joined, starts_in, targets_near
from urdfctl.lint.planning import (
    Arguments,
    Plan,
    PlannedTarget,
    TargetOrigin,
    is_launched_already,
    is_robot,
    with_bringups,
)
from urdfctl.lint.results import TargetResult, Unjoined
from urdfctl.lint.unjoined import unjoined
from urdfctl.load.target import Target
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around, package_name
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    from typing import Protocol

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
    unjoined: launch files that start controllers, and no robot that these fit; or a robot that is not here.
    covered: launch files that only spawn controllers, each with one that starts the robot and spawns them, too.
    despite: files that were linted although COLCON_IGNORE or CATKIN_IGNORE excludes them: there is nothing else.
    """

    robots: list[TargetResult]
    targets: LintedTargets
    silent: tuple[TargetResult, ...] = ()
    unjoined: tuple[Unjoined, ...] = ()
    despite: tuple[str, ...] = ()
    covered: tuple[tuple[str, str], ...] = ()

    @property
    def unused(self) -> list[TargetResult]:
        """The results of what no robot uses and no launch file starts; `unjoined` says it of launch files that start
        controllers."""
        used = {id(result) for result in self.robots}
        told = {each.path for each in self.unjoined}.union(file for result in self.silent for file in result.files)
        told |= {path for result in self.results if result.bringup for path in result.bringup.includes}
        return [result for result in self.results if id(result) not in used and result.path not in told]

    @property
    def results(self) -> list[TargetResult]:
        """Return the results of all targets."""
        return [result for _, result in self.targets]

    @property
    def crashed(self) -> bool:
        """Return whether urdfctl crashed on any target."""
        return any(result.outcome.crashed for result in self.results)


class Launches(NamedTuple):
    """The results of launch files.

    started: of all of them.
    reported: of those that are reported for themselves.
    """

    started: LaunchedTargets
    reported: LaunchedTargets

    @property
    def of_robots(self) -> list[TargetResult]:
        """The results of those that start a robot."""
        return [result for _, (_, result) in self.started if result.launch]

    @property
    def silent(self) -> list[TargetResult]:
        """The results of those that start a robot, and are not worth mentioning."""
        return [result for entry, (_, result) in self.started if _is_silent(entry, result)]


def judge(plan: Plan, linter: TargetLinter) -> LintRun:
    """Return the results of a plan."""

    def linted(targets: list[Target], focus: Sequence[Sequence[str]] = ()) -> Iterator[tuple[Target, TargetResult]]:
        return zip(targets, linter.lint(targets, focus), strict=True)

    files = plan.files
    started = _launched([entry for entry in plan.targets if entry.is_launched], linted, linter)
    started += _launched(_not_followed(files, started), linted, linter)
    started += _documented(files, started, linted, linter)
    launches = Launches(started, [(entry, pair) for entry, pair in started if entry.is_reported(pair[1])])
    reported = _described(plan.targets, launches, linted)
    together = _with_chosen(_together(launches.started, reported, linted), launches.started, linter, linted)
    reported = _with_joined(reported, together)
    reported += linted(_unread(files.controllers, reported))
    reported = _paired(reported, _unread(files.controllers_candidates, reported), linted)
    unused = [Target(path, fragment=True) for path in files.unread(_files_read(reported))]
    unused += _unread(files.controllers_candidates, reported)
    reported = as_used(reported, _named(files), launches.of_robots)
    silent = tuple(result for result in launches.silent if id(result) not in together.replaced)
    run = LintRun(
        robots=_robots(reported, files),
        targets=[*reported, *as_unused(linted(unused), _used_otherwise(unused, reported))],
        silent=silent,
        unjoined=_unjoined(launches, reported, together),
        despite=tuple(files.despite),
        covered=together.covered,
    )
    return _without_generated(run, files)


def _described(plan: Sequence[PlannedTarget], launches: Launches, linted: LintTargets) -> LintedTargets:
    """The targets of a plan that are no launch files, and of these those that start nothing of the first."""
    entries = _not_launched(plan, launches.reported)
    again = {os.path.abspath(entry.target.launch) for entry in entries if entry.target.launch}
    results = list(zip(linted([entry.target for entry in entries]), entries, strict=True))
    starts = launches.of_robots
    kept = [pair for pair in results if pair[1].is_reported(pair[0][1])]
    kept = kept if kept or starts else [pair for pair in results if _is_broken_robot(pair[0][1])]
    described = [(target, as_started(entry, result, starts)) for (target, result), entry in kept]
    return described + [pair for _, pair in launches.reported if pair[1].launch not in again]


def _is_broken_robot(result: TargetResult) -> bool:
    """Whether a description that is no robot should be one: a joint leads to a link that it does not have."""
    return result.complete and bool(result.links and result.joining.joints) and result.robot is not None


def _with_joined(reported: LintedTargets, together: Joined) -> LintedTargets:
    """The targets, with those that are started beside each other in the place of each of them alone."""
    covered = {(result.path, result.arguments) for _, result in together.results}
    alone = [pair for pair in reported if id(pair[1]) not in together.replaced]
    alone = [pair for pair in alone if not (_is_alone(pair) and _key(pair[1]) in covered)]
    return sorted([*together.results, *alone], key=lambda pair: pair[0].guessed)  # a finding names the first


def _unjoined(launches: Launches, reported: LintedTargets, together: Joined) -> tuple[Unjoined, ...]:
    """The launch files that the user names, or in a folder of theirs, which start controllers without a robot."""
    meant = [pair for entry, pair in launches.started if entry.origin is not TargetOrigin.AROUND] + reported
    included = {path for _, result in meant if result.bringup for path in result.bringup.includes}
    left = [result for _, result in meant if id(result) not in together.replaced]
    left = [result for result in left if result.path not in included or _is_told(result)]
    return tuple(unjoined(left, starts_in(meant)))


def _is_told(result: TargetResult) -> bool:
    """Whether something says that a launch file is started alone, though another one includes it."""
    return result.bringup is not None and result.bringup.told_at is not None


def _robots(reported: LintedTargets, files: DiscoveredFiles) -> list[TargetResult]:
    named = {os.path.abspath(path) for path in files.launches}
    return [result for _, result in reported if result.path in named or not is_launch(result.path)]


def _together(started: LaunchedTargets, reported: LintedTargets, linted: LintTargets) -> Joined:
    """What is started beside each other: launch files without a robot, with those that start one."""
    wanted = {id(result) for entry, (_, result) in started if entry.origin is not TargetOrigin.AROUND}
    wanted |= {id(result) for _, result in reported}
    launched = [pair for _, pair in started]
    known = {id(result) for _, result in launched}
    named = [target.path for target, result in reported if is_lonely(result) and id(result) not in known]
    near = list(dict.fromkeys(target for path in named for target in targets_near(path)))
    return joined([*launched, *reported, *(linted(near) if near else ())], wanted, linted)


def _with_chosen(together: Joined, started: LaunchedTargets, linter: TargetLinter, linted: LintTargets) -> Joined:
    """What is started beside each other, and starts with an argument by which they include what nothing else fits."""
    launched = [pair for _, pair in started]
    chosen = chosen_starts(launched, together.replaced, linter.variants, linted)
    included = {path for _, result in chosen if result.bringup for path in result.bringup.includes}
    covered = {id(result) for _, result in launched if is_lonely(result) and result.path in included}
    return together._replace(results=(*together.results, *chosen), replaced=together.replaced | covered)


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
    kept = [entry for entry in left if entry.origin is not TargetOrigin.FOUND or not is_backup(entry.target.path)]
    left = kept if kept or known else left
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

    results = _outer(list(zip(entries, linted(entries), strict=True)))
    known = {os.path.abspath(entry.target.path) for entry in entries}
    given, replaced = _with_arguments(results, linter)
    results = [(entry, pair) for entry, pair in results if entry.target not in replaced]
    results += _without_parts(list(zip(given, linted(given), strict=True)))
    more: list[PlannedTarget] = []
    for entry, (target, result) in results:
        bringup = result.bringup
        if bringup is not None:
            more += [entry._replace(target=other) for other in _other_robots(target, result)]
            used = bringup.includes if result.joining.described_in else ()  # their defaults are not used
            launches = filter(is_launch, bringup.unfollowed)
            inner = [path for path in launches if os.path.abspath(path) not in known]
            known.update(map(os.path.abspath, inner))
            more += [entry._replace(target=Target(path, guessed=path in used)) for path in inner]
    return [*results, *zip(more, linted(more), strict=True)]


def _other_robots(target: Target, result: TargetResult) -> Iterator[Target]:
    """Yield a target for each other robot that a launch file starts."""
    for path, namespace in result.bringup.others if result.bringup else ():
        if target.arguments:
            yield target._replace(namespace=namespace)
        else:
            yield Target(path, launch=result.launch, namespace=namespace)


def _with_arguments(results: LaunchedTargets, linter: TargetLinter) -> tuple[list[PlannedTarget], set[Target]]:
    """The launch files with the arguments that they need, or are documented to be given; and the targets that those
    which need some replace."""
    more: list[PlannedTarget] = []
    replaced: set[Target] = set()
    alone = [(entry, lacks_robot(result)) for entry, (_, result) in results if not entry.target.launch]
    asked = [(entry, is_needy) for entry, is_needy in alone if is_needy or entry.target.documented]
    choices = linter.variants([entry.target for entry, _ in asked]) if asked else ()
    for (entry, is_needy), targets in zip(asked, choices, strict=True):
        given = [target for target in targets if target.arguments and (is_needy or not target.guessed)]
        more += [entry._replace(target=target) for target in given]
        if given and (is_needy or all(target.arguments for target in targets)):
            replaced.add(entry.target)
    return more, replaced


def _without_parts(given: LaunchedTargets) -> LaunchedTargets:
    """The results of launch files with arguments, without those with a guessed file that is only a part of a robot."""
    whole = {entry.target.path for entry, (_, result) in given if result.complete and is_robot(result)}
    return [
        (entry, pair)
        for entry, pair in given
        if not (pair[0].guessed and entry.target.path in whole and (pair[1].library or not is_robot(pair[1])))
    ]


def _not_followed(files: DiscoveredFiles, started: LaunchedTargets) -> list[PlannedTarget]:
    """The launch files that others seem to include, and that none of them starts, nor a copy: the text was in a
    comment, the path is not understood, or a condition is false, and then their arguments may not be the defaults."""
    known = {path for _, (_, result) in started for path in (result.launch or result.path, *_included(result))}
    names = set(map(_in_package, known))
    left = (path for path in files.mentioned if _in_package(path) not in names)
    texts = files.documentation
    targets = (Target(path, guessed=takes_arguments(path), documented=texts.starts(path)) for path in left)
    return [PlannedTarget(target, TargetOrigin.LAUNCHED) for target in targets]


def _in_package(path: str) -> tuple[str, str]:
    """The name of the package that a file is in, and its path there: the same in copies of the package."""
    folder = package_around(os.path.dirname(os.path.abspath(path)))
    name = package_name(os.path.join(folder, "package.xml")) if folder else None
    return (name, os.path.relpath(path, folder)) if folder and name else ("", os.path.basename(path))


def _documented(
    files: DiscoveredFiles, started: LaunchedTargets, lint_targets: LintTargets, linter: TargetLinter
) -> LaunchedTargets:
    """The launch files that others include, with the arguments with which people start them alone, or without any."""
    included = {path for _, (_, result) in started for path in _included(result)}
    texts = files.documentation
    inner = [
        Target(path, documented=texts.starts(path), told_at=texts.bare_start(path) if takes_arguments(path) else None)
        for path in files.mentioned
        if os.path.abspath(path) in included
    ]
    found = documented_starts(inner, [pair for _, pair in started], linter.variants, lint_targets)
    return [(PlannedTarget(pair[0], TargetOrigin.LAUNCHED), pair) for pair in found]


def _included(result: TargetResult) -> tuple[str, ...]:
    return (*result.bringup.includes, *result.bringup.unfollowed) if result.bringup else ()


def _outer(launched: LaunchedTargets) -> LaunchedTargets:
    """The results without those of launch files that another one of them includes, as following it shows."""
    includes = {
        os.path.abspath(entry.target.path): set(result.bringup.includes)
        for entry, (_, result) in launched
        if result.bringup
    }

    inner = {path for outer, paths in includes.items() for path in paths if outer not in includes.get(path, ())}
    return [(entry, pair) for entry, pair in launched if os.path.abspath(entry.target.path) not in inner]


def lacks_robot(result: TargetResult) -> bool:
    """Return whether a launch file does not say which robot it starts, or needs arguments to know it."""
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


def _used_otherwise(unused: Sequence[Target], reported: LintedTargets) -> set[str]:
    """The files among unused ones that a robot includes with other arguments; all of them if there is no robot."""
    paths = [os.path.abspath(target.path) for target in unused]
    robots = any(result.links for _, result in reported)
    return included_from(sorted(_files_read(reported)), paths) if robots else set(paths)


def _files_read(targets: LintedTargets) -> set[str]:
    return {file for _, result in targets for file in result.files}


def _unread(paths: list[str], targets: LintedTargets) -> list[Target]:
    """Return the files that were not read for any target."""
    read = _files_read(targets)
    return [Target(path) for path in paths if os.path.abspath(path) not in read]
