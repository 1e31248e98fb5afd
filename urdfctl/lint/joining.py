"""Join launch files that are started beside each other: one starts a robot, another one its controllers.

A launch file that loads or spawns controllers, and that starts no robot, belongs to a robot with the joints that these
controllers command, of the same generation of ROS; one that only spawns controllers, to the start that declares them.
Its own package comes first, then the others of the run.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Sequence
from itertools import islice

from urdfctl.discover.robots import discover_files
from urdfctl.lint.results import TargetResult
from urdfctl.load.target import LaunchStart, Target
from urdfctl.names import nearest
from urdfctl.source.disk.files import is_launch
from urdfctl.source.workspaces.packages import package_around
from urdfctl.startup.records import NamedTuple

Pair = tuple[Target, TargetResult]
_MOST_STARTS = 3
"""Starts of the same robot with which a launch file is joined."""
_MOST_NEAR = 24
"""Launch files, and descriptions, that may start the robot of a launch file that the user names."""


class Join(NamedTuple):
    """A launch file without a robot, and the starts beside which it may be started."""

    lonely: Pair
    starts: tuple[Pair, ...]

    def targets(self) -> list[Target]:
        """Return, for each start, what it and the launch file start together."""
        path, arguments = self.lonely[0].path, self.lonely[0].arguments
        return [
            target._replace(beside=(*target.beside, LaunchStart(path, arguments)))
            if result.launch
            else target._replace(launch=path)
            for target, result in self.starts
        ]


def is_lonely(result: TargetResult) -> bool:
    """Return whether a result is of a launch file that loads or spawns controllers, and starts no robot."""
    if not is_launch(result.path) or result.links is not None or result.bringup is None:
        return False
    return bool(result.joining.declared or result.bringup.spawned)


def targets_near(path: str) -> list[Target]:
    """Return what may start the robot of a launch file: what else is in its package, or its folder."""
    folder = os.path.dirname(os.path.abspath(path))
    files = discover_files([package_around(folder) or folder])
    launches = (launch for launch in files.launch_candidates if os.path.abspath(launch) != os.path.abspath(path))
    return [*map(Target, islice(launches, _MOST_NEAR)), *map(Target, files.candidates[:_MOST_NEAR])]


def joins(lonely: Iterable[Pair], starts: Sequence[Pair], wanted: Collection[int]) -> list[Join]:
    """Return each launch file without a robot for which there are starts beside which it may be started.

    wanted: as in `joined`.
    """
    robots = [pair for pair in starts if _is_robot(pair[1])]
    found = []
    for pair in lonely:
        fitting = _fitting(pair[1], robots)
        if id(pair[1]) not in wanted:
            fitting = [start for start in fitting if id(start[1]) in wanted]
        if fitting:
            found.append(Join(pair, tuple(fitting)))
    return found


def _is_robot(result: TargetResult) -> bool:
    return (result.links or 0) > 1 and not result.library


def _fitting(lonely: TargetResult, robots: Sequence[Pair]) -> list[Pair]:
    """The starts that a launch file is started beside: with the same robot, the best known ones."""
    same = [pair for pair in robots if None in (pair[1].ros, lonely.ros) or pair[1].ros == lonely.ros]
    own = [pair for pair in same if _package(pair[1]) == _package(lonely)]
    fits = _has_joints if lonely.joining.claimed else _declares
    for near in (own, same):
        whole = [pair for pair in near if fits(lonely, pair[1])]
        if whole:
            return _best(whole)
    meant = [pair for pair in own if _may_be_meant(lonely, pair[1])] if len({pair[1].path for pair in own}) == 1 else []
    return _best(meant) if meant else []


def _package(result: TargetResult) -> str:
    """The folder of the package that starts a target; that of its file outside of packages."""
    folder = os.path.dirname(result.launch or result.path)
    return package_around(folder) or folder


def _has_joints(lonely: TargetResult, robot: TargetResult) -> bool:
    return set(lonely.joining.claimed) <= set(robot.joining.joints)


def _declares(lonely: TargetResult, start: TargetResult) -> bool:
    spawned = _spawned(lonely)
    return bool(spawned) and spawned <= {*start.joining.declared, *lonely.joining.declared}


def _spawned(result: TargetResult) -> set[str]:
    return {name.rpartition("/")[2] for name in (result.bringup.spawned if result.bringup else ())}


def _may_be_meant(lonely: TargetResult, robot: TargetResult) -> bool:
    """Whether the only robot of a package is meant, though it lacks something: some names fit, or all nearly do."""
    wanted, there = set(lonely.joining.claimed), robot.joining.joints
    if not wanted:
        wanted, there = _spawned(lonely), robot.joining.declared
    known = wanted & set(there)
    return bool(known) or (bool(wanted) and all(nearest(name, there) for name in wanted))


def _best(fitting: Sequence[Pair]) -> list[Pair]:
    """Those that launch files start, with a manager or a simulator if any has one; of one robot, if all are."""
    best = list(fitting)
    for is_better in (_is_launched, _manages):
        best = [pair for pair in best if is_better(pair[1])] or best
    return best[:_MOST_STARTS]


def _is_launched(result: TargetResult) -> bool:
    return result.launch is not None


def _manages(result: TargetResult) -> bool:
    return result.joining.manages


class Joined(NamedTuple):
    """What was joined.

    results: the targets with what is started beside them.
    replaced: the identities of the results that these stand for: of starts, and of launch files without a robot.
    """

    results: tuple[Pair, ...] = ()
    replaced: frozenset[int] = frozenset()


def joined(every: Iterable[Pair], wanted: Collection[int], lint: Callable[[list[Target]], Iterable[Pair]]) -> Joined:
    """Return launch files without a robot, joined with the starts beside which they are started.

    A launch file that spawns what another one loads is joined with the result of that.

    every: starts, and launch files without a robot.
    wanted: the identities of the results of which one must be in a join.
    """
    starts = list({id(pair[1]): pair for pair in every}.values())
    lonely = [pair for pair in starts if is_lonely(pair[1])]
    loading = [pair for pair in lonely if pair[1].joining.claimed]
    first = _joined_once(joins(loading, starts, wanted), lint)
    left = [pair for pair in lonely if id(pair[1]) not in first.replaced]
    now = [pair for pair in starts if id(pair[1]) not in first.replaced]
    made = {id(result) for _, result in first.results}
    second = _joined_once(joins(left, [*first.results, *now], made.union(wanted)), lint)
    kept = [pair for pair in first.results if id(pair[1]) not in second.replaced]
    return Joined((*kept, *second.results), first.replaced | second.replaced)


def _joined_once(made: Sequence[Join], lint: Callable[[list[Target]], Iterable[Pair]]) -> Joined:
    if not made:
        return Joined()
    linted = iter(list(lint([target for join in made for target in join.targets()])))
    results: list[Pair] = []
    replaced: set[int] = set()
    for join in made:
        together = [next(linted) for _ in join.starts]
        results += _certain(join, together)
        replaced |= {id(result) for _, result in (join.lonely, *join.starts)}
    return Joined(tuple(results), frozenset(replaced))


def _certain(join: Join, together: Sequence[Pair]) -> list[Pair]:
    """The results without those findings that hold only for some of several starts."""
    in_all = set.intersection(*(_keys(result) for _, result in together))
    of_starts = [_keys(start) for _, start in join.starts]
    return [
        (target, _only(result, in_all | of_start))
        for (target, result), of_start in zip(together, of_starts, strict=True)
    ]


def _keys(result: TargetResult) -> set[tuple[str, str, int]]:
    return {(finding.code, finding.at.file, finding.at.start) for finding in result.outcome.diagnostics}


def _only(result: TargetResult, keys: set[tuple[str, str, int]]) -> TargetResult:
    kept = [one for one in result.outcome.diagnostics if (one.code, one.at.file, one.at.start) in keys]
    return result._replace(outcome=result.outcome._replace(diagnostics=kept))
