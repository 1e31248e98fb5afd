"""UC467."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.session import Session
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.claims.common import seen
from urdfctl.rules.common import in_words

_ROBOT = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
      <joint name="elbow">%s<state_interface name="position"/></joint>
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
_COMMAND = '<command_interface name="position"/>'


@rule(
    "UC467",
    severity=Severity.INFO,
    runtime="works",
    authority="ros2_control and ros_control: a joint moves when a controller commands it",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _ROBOT % f"«{_COMMAND}»", "controllers.yaml": _CONTROLLERS % "shoulder"}],
    good=[{"robot.urdf": _ROBOT % _COMMAND, "controllers.yaml": _CONTROLLERS % "shoulder, elbow"}],
)
def joint_not_commanded(project: Project) -> Iterator[Finding]:
    """Joint is not commanded by any controller.

    The hardware accepts commands for the joint, but no controller sends any: the joint stays where it is, or falls.
    This may be intended, as its controller may be in another file.
    """
    sessions = seen(project)
    if not sessions or project.robot is None:
        return
    session = sessions[-1]
    if session.hardware.known and all(controller.claims.complete for controller in session.controllers):
        yield from _idle(session, [joint.name for joint in project.robot.joints if joint.name])


def _idle(session: Session, joints: list[str]) -> Iterator[Finding]:
    claimed = {claim.component for controller in session.controllers for claim in controller.claims.command}
    commanded = [joint for joint in joints if joint in session.hardware.command]
    idle = [joint for joint in commanded if joint not in claimed]
    if not idle or len(idle) == len(commanded):
        return
    joint_is = "joint {} is" if len(idle) == 1 else "joints {} are"
    at = session.hardware.command[idle[0]][0].at
    yield Finding(at, f"{joint_is.format(in_words(idle))} not commanded by any controller in these files")
