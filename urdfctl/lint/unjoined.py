"""Which launch files belong to no robot that is started, and the fact that is missing."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfctl.lint.joining import (
    Start,
    is_lonely,
    names_without_namespace,
    package_of,
    spawned_by,
    starts_of_generation,
)
from urdfctl.lint.results import TargetResult, Unjoined
from urdfctl.source.disk.files import is_launch


def unjoined(left: Iterable[TargetResult], starts: Sequence[Start]) -> list[Unjoined]:
    """Return those results that start controllers without a robot, or what is not here, each file once, with the fact
    that is missing.

    left: the results that are in no join.
    """
    lonely = {result.path: result for result in left if _starts_robot(result) or _is_absent(result)}
    return [_missing(result, starts_of_generation(result, starts)) for result in lonely.values()]


def _starts_robot(result: TargetResult) -> bool:
    """Whether a result is of a launch file without a robot that starts more than the world of a simulator."""
    return is_lonely(result) and (_controls(result) or result.joining.puts)


def _controls(result: TargetResult) -> bool:
    """Whether a result is of a launch file without a robot that starts controllers, or a manager beside a simulator."""
    facts = result.joining
    only_simulates = facts.simulates and not facts.declared and not spawned_by(result)
    return is_lonely(result) and not only_simulates


def _is_absent(result: TargetResult) -> bool:
    """Whether a result is of a launch file whose robot, or what starts it, does not exist, is not known, is no
    description that is read, or is in a package that is not here."""
    facts = result.joining
    missing = facts.described_in or facts.started_in or facts.gone or facts.lost or facts.unfound or facts.models
    return is_launch(result.path) and result.links is None and bool(missing or facts.unread)


def _missing(lonely: TargetResult, starts: Sequence[Start]) -> Unjoined:
    if lonely.joining.described_in:
        return Unjoined(lonely.path, packages=lonely.joining.described_in, controls=_controls(lonely))
    absent = Unjoined(
        lonely.path,
        packages=lonely.joining.started_in,
        controls=_controls(lonely),
        includes=bool(lonely.joining.started_in),
        leftover=lonely.joining.leftover,
        description=lonely.joining.lost or lonely.joining.unfound,
        is_found_nowhere=bool(lonely.joining.lost),
        models=lonely.joining.models,
        undescribed=lonely.joining.unread,
        gone=lonely.joining.gone,
        variables=lonely.joining.variables if lonely.joining.unread else (),
    )
    is_known = lonely.joining.unread or lonely.joining.leftover or not absent.controls or _is_elsewhere(lonely)
    if is_known:
        return absent
    reasons = [_missing_in(lonely, start) for start in starts]
    return min(reasons, key=lambda reason: len(reason.joints + reason.controllers), default=absent)


def _is_elsewhere(lonely: TargetResult) -> bool:
    """Whether the robot is started by a launch file that is not here, or cannot be read, or its description is not."""
    return bool(lonely.joining.started_in or lonely.joining.gone or lonely.joining.unfound)


def _missing_in(lonely: TargetResult, start: Start) -> Unjoined:
    is_whole = all(result.complete for _, result in start.robots)
    joints = {joint for _, joint in lonely.joining.claimed} - start.joints if is_whole else ()
    spawned = names_without_namespace(spawned_by(lonely))
    declared = start.declared | names_without_namespace(lonely.joining.declared)
    reason = Unjoined(lonely.path, start.first.path, tuple(sorted(joints)), tuple(sorted(spawned - declared)))
    return reason if _has_in_common(lonely, start, reason) else reason._replace(robot=None)


def _has_in_common(lonely: TargetResult, start: Start, reason: Unjoined) -> bool:
    """Whether a start is worth naming for what it lacks: one of the same package, or with some of what is wanted."""
    if package_of(lonely) == package_of(start.first) or not (reason.joints or reason.controllers):
        return True
    wanted = {joint for _, joint in lonely.joining.claimed} or names_without_namespace(spawned_by(lonely))
    return len(wanted) > len(reason.joints or reason.controllers)
