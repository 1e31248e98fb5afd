"""The joints that controllers name in their parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import Claim, claims
from urdfctl.control.hardware import Hardware, fixed_joints, hardware_of
from urdfctl.memory import once_per_object
from urdfctl.model.robot import Robot
from urdfctl.record import NamedTuple
from urdfctl.rule import Note, Project, Severity
from urdfctl.rules.common import Names, whole_robot_in
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.parameters import known_as
from urdfctl.rules.controllers.readers import Reader
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place

_SIDES = {"left": "right", "front": "rear", "l": "r", "upper": "lower", "top": "bottom"}


class Named(NamedTuple):
    """A joint that a parameter names: the claim that it leads to, and where the name stands."""

    claim: Claim
    at: Place

    @property
    def name(self) -> str:
        """The joint's name."""
        return self.claim.component


def robot_of(project: Project) -> Robot | None:
    """The robot, where nothing of it and of its controllers is missing: only then a name may be called unknown."""
    robot = whole_robot_in(project)
    if robot is None or project.library or not project.complete or not robot.joints:
        return None
    return robot if controllers_in(project).complete else None


@once_per_object
def named(reader: Reader) -> tuple[Named, ...]:
    """What a controller's parameters name for its claims, each place once."""
    return tuple(_named(reader))


def _named(reader: Reader) -> Iterator[Named]:
    if reader.type is None or reader.controller is None:
        return
    claimed = claims(reader.type, reader.controller.name, {name: _readable(reader, name) for name in reader.given})
    told: set[Place] = set()
    for claim in (*claimed.command, *claimed.state) if claimed else ():
        value = reader.located.value(claim.parameter) if claim.parameter else None
        if value is None:
            continue
        at = value.items[claim.element].at if claim.element is not None and value.items else value.at
        if at not in told:
            told.add(at)
            yield Named(claim, at)


def _readable(reader: Reader, name: str) -> object:
    """A value that can be claimed from: one of a wrong type is not read."""
    found, value = known_as(reader, name), reader.given[name]
    wrong = found is not None and type_problem(value, reader.known[found[0]], reader.distro) is not None
    return UNKNOWN if wrong else value


def meant_by(names: Names, wrong: Named, beside: set[str]) -> str | None:
    """The joint that a wrong name surely means: like it, not one of its `beside`, and not another of a row or side."""
    right = names.meant_by(wrong.name)
    if right is None or right in beside or in_row(right) == in_row(wrong.name):
        return None
    return right


def in_row(name: str) -> str:
    """A name without what tells it from others of its row: numbers, and sides."""
    words = re.split(r"([a-zA-Z]+)", re.sub(r"\d+", "0", name))
    swapped = {**{right: left for left, right in _SIDES.items()}}
    return "".join(swapped.get(word.lower(), word.lower()) for word in words)


def hardware_in(project: Project, robot: Robot) -> dict[str, Hardware]:
    """The hardware, by distro; where nothing can be said of it, one that has the robot's joints."""
    joints = frozenset(robot.joint_names)
    found = {distro: hardware_of(project, distro) for distro in project.distros}
    only = Hardware(joints=joints, fixed=fixed_joints(robot), known=False)
    return {distro: hardware if hardware.known else only for distro, hardware in found.items()}


def severity_of(project: Project, hardware: Hardware, *, meant: bool, others: bool) -> Severity:
    """How bad a wrong name of a joint is. Where it is not known which controllers are started, a name that none of the
    robot's is `meant` by may be for another robot, all the more where the `others` in the list are not its either."""
    if project.started is None and not (meant and others):
        return Severity.WARNING if meant or others else Severity.INFO
    return Severity.ERROR if hardware.known and not hardware.open else Severity.WARNING


def links_called(robot: Robot, name: str) -> Iterator[Note]:
    """That a name is a link's, and which joint moves that."""
    if not any(link.name == name for link in robot.links):
        return
    for joint in robot.joints:
        if joint.child is not None and joint.child.name == name:
            yield Note(f"'{name}' is a link; the joint that moves it is '{joint.name}'", joint.at)
