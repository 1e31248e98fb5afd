"""The joints that controllers name in their parameters."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.value_types import type_problem
from urdfctl.control.claims import Claim, claims
from urdfctl.control.hardware.gazebo_ros1 import may_be_driven
from urdfctl.control.hardware.interfaces import OfferedHardware, fixed_joints
from urdfctl.control.hardware.offered import hardware_of
from urdfctl.control.parameters.readers import Reader
from urdfctl.model.robot import Robot
from urdfctl.names import in_row
from urdfctl.rule import Project, Severity
from urdfctl.rules.common import KnownNames
from urdfctl.rules.controllers.parameters import known_as
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple

_LOOKING_UP = frozenset(
    (
        *(f"{kind}_controllers/JointTrajectoryController" for kind in ("position", "velocity", "effort", "pos_vel")),
        *("pos_vel_acc_controllers/JointTrajectoryController", "position_controllers/GripperActionController"),
        *("effort_controllers/GripperActionController", "effort_controllers/JointGroupPositionController"),
        *("effort_controllers/JointPositionController", "velocity_controllers/JointPositionController"),
    )
)
"""The controllers of ROS 1 whose init() fails for a joint that the description lacks (ros_controllers, getUrdfJoints() of
joint_trajectory_controller and gripper_action_controller, urdf::Model::getJoint() of the others)."""


class Named(NamedTuple):
    """A joint that a parameter names."""

    claim: Claim
    """The claim made with this name."""
    at: Place
    """Where the name is written."""

    @property
    def name(self) -> str:
        """The joint's name."""
        return self.claim.component


@once_per_object
def named(reader: Reader) -> tuple[Named, ...]:
    """Return the joints that a controller's parameters name for its claims, each place once."""
    return tuple(_named(reader))


def _named(reader: Reader) -> Iterator[Named]:
    if reader.type is None or reader.controller is None:
        return
    claimed = claims(reader.type, reader.controller.name, {name: _readable(reader, name) for name in reader.given})
    seen: set[Place] = set()
    for claim in (*claimed.command, *claimed.state) if claimed else ():
        value = reader.located.value(claim.parameter) if claim.parameter else None
        if value is None:
            continue
        at = value.items[claim.element].at if claim.element is not None and value.items else value.at
        if at not in seen:
            seen.add(at)
            yield Named(claim, at)


def _readable(reader: Reader, name: str) -> object:
    """The value of a parameter; UNKNOWN if it has the wrong type, as the controller then does not read it."""
    matched, value = known_as(reader, name), reader.given[name]
    wrong = matched is not None and type_problem(value, reader.known[matched[0]], reader.distro) is not None
    return UNKNOWN if wrong else value


def meant_by(names: KnownNames, wrong: Named, beside: set[str]) -> str | None:
    """Return the joint that a wrong name almost certainly means, or None.

    The joint has a similar name, is not in `beside`, and is not just a joint with another number or side.
    """
    right = names.meant_by(wrong.name)
    if right is None or right in beside or in_row(right) == in_row(wrong.name):
        return None
    return right


def looks_joints_up(reader: Reader) -> bool:
    """Return whether a controller of ROS 1 fails for a joint that the description lacks, whatever the driver has."""
    return reader.type is not None and reader.type.type in _LOOKING_UP


def hardware_in(project: Project, robot: Robot) -> dict[str, OfferedHardware]:
    """Return the hardware by distro; if it is unknown, a Hardware with only the robot's joints."""
    by_distro = {distro: hardware_of(project, distro) for distro in project.distros}
    joints_only = OfferedHardware(joints=frozenset(robot.joint_names), fixed=fixed_joints(robot), known=False)
    return {distro: hardware if hardware.known else joints_only for distro, hardware in by_distro.items()}


def severity_of(
    project: Project,
    hardware: OfferedHardware,
    *,
    meant: bool,
    others: bool,
    slip: bool = False,
    looked_up: bool = False,
) -> Severity:
    """Return the severity of a joint name of a controller that is wrong.

    If it is unknown which controllers are started, the controller may be for another robot, unless its file is named
    with this one. This is less likely if the name resembles a joint of the robot (`meant`), or if the robot has
    `others` of the list. A driver may export more joints than the description lists, but none whose name is one of
    theirs with a `slip`. Drivers of ROS 1 name the joints themselves, but the controller may have them `looked_up` in
    the description.
    """
    if project.started is None and not project.together and not (meant and others):
        return Severity.WARNING if meant or others else Severity.INFO
    sure = hardware.known and not hardware.open and (looked_up or not may_be_driven(project))
    return Severity.ERROR if slip or sure else Severity.WARNING
