"""UC457."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.claims import Claim
from urdfctl.control.conflicts import claimed_twice, resource
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.claims.common import of_each_candidate, place_of

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
"""
_CONTROLLERS = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        states: {type: joint_state_broadcaster/JointStateBroadcaster}
        arm: {type: forward_command_controller/ForwardCommandController}
    arm:
      ros__parameters:
        joints: [%s]
        interface_name: position
"""


@rule(
    "UC457",
    severity=Severity.ERROR,
    authority='ros2_control controller_manager/src/controller_manager.cpp: "The command interfaces of the controller '
    "'arm' are not unique. Please make sure that the command interfaces are unique\"; ros_control "
    "hardware_interface/robot_hw.h, checkForConflict: 'Resource conflict on [elbow].  Controllers = [arm, arm]'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "shoulder, elbow, «elbow»"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "shoulder, elbow"},
)
def interface_claimed_twice(project: Project) -> Iterator[Finding]:
    """A controller claims the same command interface twice.

    ROS 2 refuses the controller: when it is configured from jazzy on, before when it is to be activated, for the second
    claim finds the interface taken. In ROS 1 it is the joint that counts: a controller that wants it in two interfaces
    is in conflict with itself.
    """
    return of_each_candidate(project, _twice)


def _twice(session: Session, one: Configured) -> Iterator[Finding]:
    for earlier, claim in claimed_twice(one, session.distro):
        of_interface = claim.element == earlier.element and claim.parameter == earlier.parameter
        at = place_of(one, claim, of_interface=of_interface and claim.interface_parameter is not None)
        first = place_of(one, earlier, of_interface=of_interface and earlier.interface_parameter is not None)
        if at is None or first is None or _is_told(one, claim):
            continue
        what = "joint" if generation(session.distro) == 1 else "command interface"
        notes = (Note("the first time", first),) if first is not at else ()
        yield Finding(at, f"controller '{one.name}' claims the {what} '{resource(claim, session.distro)}' twice", notes)


def _is_told(one: Configured, claim: Claim) -> bool:
    """Whether the controller refuses a list that names anything twice, as UC433 tells."""
    parameter = one.type.parameters.get(claim.parameter) if one.type and claim.parameter else None
    return parameter is not None and "unique" in parameter.validators
