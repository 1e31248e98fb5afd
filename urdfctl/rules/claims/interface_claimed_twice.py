"""UC457."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import generation
from urdfctl.control.claims import Claim
from urdfctl.control.conflicts import claimed_twice, resource
from urdfctl.control.session import Configured, Session
from urdfctl.rule import Finding, Note, Project, Severity, StageDependsOn, rule
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
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    authority='ros2_control controller_manager/src/controller_manager.cpp: "The command interfaces of the controller '
    "'arm' are not unique. Please make sure that the command interfaces are unique\"; ros_control "
    "hardware_interface/robot_hw.h, checkForConflict: 'Resource conflict on [elbow].  Controllers = [arm, arm]'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "shoulder, elbow, «elbow»"}],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "shoulder, elbow"}],
)
def interface_claimed_twice(project: Project) -> Iterator[Finding]:
    """Controller claims an interface twice.

    ROS 2 refuses the controller: from jazzy on when it is configured, earlier when it is activated, because its first
    claim has taken the interface. ROS 1 compares joints: a controller that claims a joint in two hardware interfaces is
    in conflict with itself.
    """
    return of_each_candidate(project, _twice)


def _twice(session: Session, controller: Configured) -> Iterator[Finding]:
    for earlier, claim in claimed_twice(controller, session.distro):
        of_interface = claim.element == earlier.element and claim.parameter == earlier.parameter
        at = place_of(controller, claim, of_interface=of_interface and claim.interface_parameter is not None)
        first = place_of(controller, earlier, of_interface=of_interface and earlier.interface_parameter is not None)
        if at is None or first is None or _is_reported_elsewhere(controller, claim):
            continue
        kind = "joint" if generation(session.distro) == 1 else "command interface"
        notes = (Note("first claimed here", first),) if first is not at else ()
        message = f"controller '{controller.name}' claims {kind} '{resource(claim, session.distro)}' twice"
        yield Finding(at, message, notes)


def _is_reported_elsewhere(controller: Configured, claim: Claim) -> bool:
    """Whether UC433 reports the duplicate, because the controller refuses a list with duplicates."""
    parameter = controller.type.parameters.get(claim.parameter) if controller.type and claim.parameter else None
    return parameter is not None and "unique" in parameter.validators
