"""Find the robot of a launch file that spawns controllers and loads no robot, among the other robots of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from urdfctl.control.session import session_of
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.smoke.results import RobotResult
from urdfctl.source.disk.files import is_launch
from urdfctl.source.opaque import UNKNOWN
from urdfctl.startup.records import NamedTuple

MOST_PAIRS = 48
"""With more pairs of launch files and robots than this, none is tried: each takes as long as reading a robot."""


class CandidatePair(NamedTuple):
    """A launch file with a robot that may be its own.

    position: that of the launch file among the targets.
    """

    position: int
    target: Target


def has_joints_of_controllers(project: Project) -> bool:
    """Return whether a robot has all joints that its controllers command, and they command any."""
    if project.robot is None or not project.distros:
        return False
    controllers = session_of(project, project.distros[-1]).controllers
    claimed = {claim.component for each in controllers for claim in each.claims.command}
    named = {name for name in claimed - {each.name for each in controllers} if UNKNOWN not in name}
    return bool(named) and named <= {*project.robot.joint_names}


def pairs_to_try(targets: Sequence[Target], results: Sequence[RobotResult]) -> list[CandidatePair]:
    """Return each launch file without a robot, with each robot of the run."""
    alone = [
        index
        for index, (target, robot) in enumerate(zip(targets, results, strict=True))
        if is_launch(target.path) and robot.linted.links is None and robot.controllers
    ]
    robots: dict[str, RobotResult] = {}
    for robot in results:
        linted = robot.linted
        if (linted.links or 0) > 1 and linted.complete and not linted.library and not robot.part_of:
            robots.setdefault(linted.path, robot)
    pairs = [
        CandidatePair(index, Target(path, robot.linted.arguments, launch=targets[index].path))
        for index in alone
        for path, robot in robots.items()
    ]
    return pairs if len(pairs) <= MOST_PAIRS else []


def only_ones(pairs: Sequence[CandidatePair], fits: Sequence[bool]) -> Mapping[int, int]:
    """Return the pairs of the launch files that exactly one robot fits: position in `pairs` by index of the target."""
    found: dict[int, list[int]] = {}
    for position, (pair, fit) in enumerate(zip(pairs, fits, strict=True)):
        if fit:
            found.setdefault(pair.position, []).append(position)
    return {index: positions[0] for index, positions in found.items() if len(positions) == 1}
