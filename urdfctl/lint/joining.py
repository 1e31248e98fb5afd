"""Join launch files that are started beside each other: one starts robots, another one their controllers.

A launch file that loads or spawns controllers, and that starts no robot, belongs to a start of robots with the joints
that these controllers command, of the same generation of ROS; one that only spawns controllers, to the start that
declares them. Its own package comes first, then the others of the run.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from itertools import islice

from urdfctl.diagnostic import Diagnostic
from urdfctl.discover.robots import discover_files
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import LaunchStart, Target
from urdfctl.names import nearest
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around
from urdfctl.startup.records import NamedTuple

Pair = tuple[Target, TargetResult]
LintPairs = Callable[[list[Target]], Iterable[Pair]]
_MOST_STARTS = 3
"""Starts beside which a launch file is checked."""
_MOST_NEAR = 24
"""Launch files, and descriptions, that may start the robot of a launch file that the user names."""


class Start(NamedTuple):
    """The robots that a launch file starts; or a description that nobody starts."""

    robots: tuple[Pair, ...]

    @property
    def first(self) -> TargetResult:
        """The result of the first robot."""
        return self.robots[0][1]

    @property
    def joints(self) -> set[str]:
        """The joints of all robots."""
        return {name for _, result in self.robots for name in result.joining.joints}

    @property
    def declared(self) -> set[str]:
        """The controllers that are declared for the robots, without namespaces."""
        return names_without_namespace(name for _, result in self.robots for name in result.joining.declared)


class Join(NamedTuple):
    """Launch files without a robot that are started together, and the starts beside which they may be started."""

    lonely: tuple[Pair, ...]
    starts: tuple[Start, ...]

    def targets(self) -> Iterator[Target]:
        """Yield, for each robot of each start, what the start and the launch files start together."""
        beside = tuple(LaunchStart(target.path, target.arguments) for target, _ in self.lonely)
        for start in self.starts:
            for target, result in start.robots:
                first = () if result.launch else beside[:1]
                given = target._replace(launch=first[0].path) if first else target
                yield given._replace(beside=(*target.beside, *beside[len(first) :]))


class Joined(NamedTuple):
    """What was joined.

    results: the targets with what is started beside them.
    replaced: the identities of the results that these stand for: of starts, and of launch files without a robot.
    covered: launch files without a robot, each with the launch file of a start that spawns all that it spawns.
    """

    results: tuple[Pair, ...] = ()
    replaced: frozenset[int] = frozenset()
    covered: tuple[tuple[str, str], ...] = ()


def is_lonely(result: TargetResult) -> bool:
    """Return whether a result is of a launch file that runs a controller manager, or loads or spawns controllers, and
    names no robot to start."""
    if not is_launch(result.path) or result.links is not None or result.bringup is None or result.joining.lost:
        return False
    return bool(result.joining.declared or result.bringup.spawned or result.joining.manages)


def targets_near(path: str) -> list[Target]:
    """Return what may start the robot of a launch file: what else is in its package, or its folder."""
    folder = os.path.dirname(os.path.abspath(path))
    files = discover_files([package_around(folder) or folder])
    launches = (launch for launch in files.launch_candidates if os.path.abspath(launch) != os.path.abspath(path))
    return [*map(Target, islice(launches, _MOST_NEAR)), *map(Target, files.candidates[:_MOST_NEAR])]


def joined(every: Iterable[Pair], wanted: Collection[int], lint: LintPairs, *, alone: bool = False) -> Joined:
    """Return launch files without a robot, joined with the starts beside which they are started.

    A launch file that spawns what another one loads is joined with the result of that.

    every: starts, and launch files without a robot.
    wanted: the identities of the results of which one must be in a join.
    alone: whether only joins with one start, of one robot, are wanted.
    """
    pairs = list({id(pair[1]): pair for pair in every}.values())
    included = {path for _, result in pairs if result.bringup for path in result.bringup.includes}
    inner = [result for _, result in pairs if is_lonely(result) and result.path in included]
    lonely = [pair for pair in pairs if is_lonely(pair[1]) and pair[1].path not in included]
    starts = starts_in(pairs)
    lonely += [start.robots[0] for start in starts if len(start.robots) == 1 and start.first.joining.waits]
    if not lonely:
        return Joined()
    wholes = {id(one): start.first.launch for _, one in lonely for start in starts[::-1] if _spawns_all(start, one)}
    parts = tuple((one.path, launch) for _, one in lonely if (launch := wholes.get(id(one))))
    covered = {*wholes}
    lonely = [pair for pair in lonely if id(pair[1]) not in covered]
    loading = [pair for pair in lonely if pair[1].joining.claimed]
    first = _joined_once(_joins(loading, starts, wanted, alone=alone), lint)
    left = [pair for pair in lonely if id(pair[1]) not in first.replaced]
    now = [pair for pair in pairs if id(pair[1]) not in first.replaced]
    made = {id(result) for _, result in first.results}
    joins = _joins(left, starts_in([*first.results, *now]), made.union(wanted), alone=alone)
    second = _joined_once(joins, lint)
    kept = [pair for pair in first.results if id(pair[1]) not in second.replaced]
    results = (*kept, *second.results)
    within = {path for _, result in results if result.bringup for path in result.bringup.includes}
    covered |= {id(result) for result in inner if result.path in within}
    return Joined(results, first.replaced | second.replaced | covered, parts)


def starts_in(pairs: Iterable[Pair]) -> list[Start]:
    """Return what starts robots: launch files with all of theirs, and descriptions."""
    found: dict[object, list[Pair]] = {}
    for target, result in pairs:
        if ((result.links or 0) > 1 and not result.library) or _has_absent_parts(result):
            beside = result.bringup.beside if result.bringup else ()
            arguments = result.bringup.arguments if result.bringup else result.arguments
            found.setdefault((result.launch or result.path, arguments, beside), []).append((target, result))
    return [Start(tuple(robots)) for robots in found.values()]


def _has_absent_parts(result: TargetResult) -> bool:
    """Whether a launch file starts a robot of which nothing is known: its parts are not here."""
    return result.launch is not None and result.links == 0 and not result.complete


# -- which belong together ---------------------------------------------------------------------------------------------


def _joins(lonely: Sequence[Pair], starts: Sequence[Start], wanted: Collection[int], *, alone: bool) -> list[Join]:
    """The launch files without a robot for which there are starts, those together that do not exclude each other."""
    found: dict[tuple[int, ...], list[list[Pair]]] = {}
    by_key: dict[tuple[int, ...], tuple[Start, ...]] = {}
    for pair in lonely:
        fitting = _fitting(pair[1], starts)
        if id(pair[1]) not in wanted:
            fitting = [start for start in fitting if any(id(result) in wanted for _, result in start.robots)]
        if not fitting or (alone and (len(fitting) > 1 or len(fitting[0].robots) > 1)):
            continue
        key = tuple(id(start.first) for start in fitting)
        by_key[key] = tuple(fitting)
        groups = found.setdefault(key, [])
        group = next((group for group in groups if not any(_exclude(pair[1], one) for _, one in group)), None)
        if group is None:
            groups.append(group := [])
        group.append(pair)
    return [Join(tuple(group), by_key[key]) for key, groups in found.items() for group in groups]


def _exclude(one: TargetResult, other: TargetResult) -> bool:
    """Whether two launch files are alternatives: they declare or spawn the same controllers, or command the same
    joints. One that only runs the manager and one that only spawns are both needed, whatever each declares."""
    if _needs(one, other) or _needs(other, one):
        return False
    return any(
        set(first) & set(second)
        for first, second in (
            (one.joining.claimed, other.joining.claimed),
            (one.joining.declared, other.joining.declared),
            (spawned_by(one), spawned_by(other)),
        )
    )


def _needs(spawning: TargetResult, managing: TargetResult) -> bool:
    """Whether a launch file only spawns controllers, and another one only runs a manager for them."""
    only_spawns = bool(spawned_by(spawning)) and not spawning.joining.manages
    return only_spawns and managing.joining.manages and not spawned_by(managing)


def spawned_by(result: TargetResult) -> tuple[str, ...]:
    """Return the controllers that a launch file spawns."""
    return result.bringup.spawned if result.bringup else ()


def names_without_namespace(names: Iterable[str]) -> set[str]:
    """Return the names of controllers, without their namespaces."""
    return {name.rpartition("/")[2] for name in names}


def starts_of_generation(lonely: TargetResult, starts: Sequence[Start]) -> list[Start]:
    """Return the starts of the generation of ROS that a launch file is for, as far as both are known."""
    return [start for start in starts if _is_of_generation(start.first, lonely)]


def _is_of_generation(start: TargetResult, lonely: TargetResult) -> bool:
    """Whether what starts a robot is run as a launch file without one is: by its form, otherwise by what is known."""
    run_as, wanted = (each.joining.form or each.ros for each in (start, lonely))
    return None in (run_as, wanted) or run_as == wanted


def _fitting(lonely: TargetResult, starts: Sequence[Start]) -> list[Start]:
    """The starts beside which a launch file is started, the best known ones.

    None, if it names another robot: one in a package that is not here, or started by a launch file there and no joints
    say otherwise. What is left over from ROS 1 in a package for ROS 2 belongs to nothing in other packages, and neither
    does what starts a robot of which the description is not known.
    """
    if lonely.joining.described_in or is_started_elsewhere(lonely):
        return []
    if lonely.joining.waits:
        return _managing(lonely, starts)
    same = [start for start in starts_of_generation(lonely, starts) if not _excludes(start, lonely)]
    if lonely.joining.manages or lonely.joining.unread:
        alone = (_only_described(start) if _is_instead(lonely, start) else start for start in same[::-1])
        described = {(start.first.path, start.first.arguments): start for start in alone}
        same = [*described.values()][::-1]
    own = [start for start in same if package_of(start.first) == package_of(lonely)]
    own = [start for start in own if start.first.launch is not None] or own
    same = own if lonely.joining.leftover or lonely.joining.unread else same
    fits = _has_joints if lonely.joining.claimed else _declares
    for near in (own, same):
        whole = [start for start in near if fits(lonely, start)]
        if whole:
            return _best(whole)
    others = starts if lonely.joining.unread else own
    there = (start.robots for start in others if package_of(start.first) == package_of(lonely))
    paths = {frozenset(result.path for _, result in robots) for robots in there}
    return _best([start for start in own if _may_be_meant(lonely, start)]) if len(paths) == 1 else []


def is_started_elsewhere(lonely: TargetResult) -> bool:
    """Whether the robot is started by a launch file that is not here, and no joints say otherwise."""
    return bool(lonely.joining.started_in) and not lonely.joining.claimed


def _managing(spawning: TargetResult, starts: Sequence[Start]) -> list[Start]:
    """The only start of a robot with its manager, beside which the controllers of that robot are spawned."""
    robot = spawning.path, spawning.arguments
    found = [
        start
        for start in starts_of_generation(spawning, starts)
        if (start.first.path, start.first.arguments) == robot
        and start.first.joining.manages
        and not any(spawned_by(result) for _, result in start.robots)
    ]
    own = [start for start in found if package_of(start.first) == package_of(spawning)] or found
    return own if len(own) == 1 else []


def _excludes(start: Start, lonely: TargetResult) -> bool:
    """Whether a start spawns controllers that a launch file would spawn a second time."""
    return any(set(spawned_by(lonely)) & set(spawned_by(result)) for _, result in start.robots)


def _spawns_all(start: Start, lonely: TargetResult) -> bool:
    """Whether a start of the same package spawns all that a launch file spawns, which is then a part of it; unless that
    has a robot or a manager of its own, or starts a robot by launch files that are not here."""
    facts = lonely.joining
    if facts.described_in or facts.started_in or facts.waits or facts.manages or facts.unread:
        return False
    wanted, spawned = set(spawned_by(lonely)), {name for _, result in start.robots for name in spawned_by(result)}
    return package_of(start.first) == package_of(lonely) and bool(wanted) and spawned >= wanted


def _is_instead(lonely: TargetResult, start: Start) -> bool:
    """Whether a launch file is started instead of a start: both publish the robot, or have a manager for it."""
    publishes = lonely.joining.unread and start.first.launch is not None
    return publishes or (lonely.joining.manages and start.first.joining.manages)


def _only_described(start: Start) -> Start:
    """The descriptions of a start, without what it starts."""
    robots = (
        (
            Target(result.path, result.arguments, namespace=target.namespace),
            result._replace(launch=None, bringup=None, joining=result.joining._replace(manages=False)),
        )
        for target, result in start.robots
    )
    return Start(tuple(robots))


def package_of(result: TargetResult) -> str:
    """Return the folder of the package that starts a target; that of its file outside of packages."""
    folder = os.path.dirname(result.launch or result.path)
    return package_around(folder) or folder


def _has_joints(lonely: TargetResult, start: Start) -> bool:
    return {joint for _, joint in lonely.joining.claimed} <= start.joints


def _declares(lonely: TargetResult, start: Start) -> bool:
    spawned = names_without_namespace(spawned_by(lonely))
    return bool(spawned) and spawned <= start.declared | names_without_namespace(lonely.joining.declared)


def _may_be_meant(lonely: TargetResult, start: Start) -> bool:
    """Whether the only robot of a package is meant, though it lacks something: some names fit, or all nearly do; or its
    parts are not here, and nothing else controls it."""
    if _has_absent_parts(start.first):
        return not start.first.joining.manages and not any(spawned_by(result) for _, result in start.robots)
    wanted, there = {joint for _, joint in lonely.joining.claimed}, start.joints
    if not wanted:
        wanted, there = names_without_namespace(spawned_by(lonely)), start.declared
        if not there and (lonely.joining.manages or not lonely.joining.declared):
            return True
    return bool(wanted & there) or (bool(wanted) and all(nearest(name, there) for name in wanted))


def _best(fitting: Sequence[Start]) -> list[Start]:
    """Those that launch files start, if any does, with a manager or a simulator, if any has one."""
    best = list(fitting)
    for is_better in (_is_launched, _manages):
        best = [start for start in best if is_better(start.first)] or best
    return best[:_MOST_STARTS]


def _is_launched(result: TargetResult) -> bool:
    return result.launch is not None


def _manages(result: TargetResult) -> bool:
    return result.joining.manages


# -- what they show together -------------------------------------------------------------------------------------------


def _joined_once(made: Sequence[Join], lint: LintPairs) -> Joined:
    if not made:
        return Joined()
    linted = iter(list(lint([target for join in made for target in join.targets()])))
    results: list[Pair] = []
    replaced: set[int] = set()
    for join in made:
        together = [_with_others(tuple(islice(linted, len(start.robots))), lint) for start in join.starts]
        results += _certain(join, together)
        replaced |= {id(result) for _, result in join.lonely}
        replaced |= {id(result) for start in join.starts for _, result in start.robots}
    return Joined(tuple(results), frozenset(replaced))


def _with_others(robots: tuple[Pair, ...], lint: LintPairs) -> Start:
    """A start with the robots that only what is started beside it shows to be others, each with its manager."""
    known = {(result.path, result.bringup.namespace) for _, result in robots if result.bringup}
    more = dict.fromkeys(
        Target(path, launch=result.launch, namespace=namespace, beside=target.beside)
        for target, result in robots
        if result.bringup
        for path, namespace in result.bringup.others
        if (path, namespace) not in known and target.beside
    )
    return Start((*robots, *(lint([*more]) if more else ())))


def _certain(join: Join, together: Sequence[Start]) -> Iterator[Pair]:
    """The results without those findings that hold only for some of several starts."""
    in_all = set.intersection(*(_keys(start) for start in together))
    for before, after in zip(join.starts, together, strict=True):
        keys = in_all | _keys(before)
        for target, result in after.robots:
            kept = [finding for finding in result.outcome.diagnostics if _key(finding) in keys]
            yield target, result._replace(outcome=result.outcome._replace(diagnostics=kept))


def _keys(start: Start) -> set[tuple[str, str, int]]:
    return {_key(finding) for _, result in start.robots for finding in result.outcome.diagnostics}


def _key(finding: Diagnostic) -> tuple[str, str, int]:
    return finding.code, finding.at.file, finding.at.start
