"""UC440."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware import Hardware
from urdfctl.control.names import is_misnamed
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import Names, in_words, replaced
from urdfctl.rules.controllers.joints import Named, hardware_in, links_called, meant_by, named, robot_of, severity_of
from urdfctl.rules.controllers.readers import Reader, in_each_distro

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
        joints: [shoulder, %s]
        interface_name: position
"""


@rule(
    "UC440",
    severity=Severity.ERROR,
    authority="ros_controllers: 'Could not find joint 'elbw' in URDF model.', 'Could not find resource 'elbw' in "
    "'hardware_interface::PositionJointInterface'.'; ros2_control: 'Unable to activate controller 'arm' since the command "
    "interface 'elbw/position' is not available.'",
    whole_robot=True,
    in_library=False,
    options=["--distro=jazzy"],
    bad={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«elbw»"},
    good={"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"},
)
def controller_joint_unknown(project: Project) -> Iterator[Finding]:
    """A controller names a joint that the robot does not have.

    The controller is not loaded (ROS 1), or loaded and never activated (ROS 2). Where it is not known which controllers
    are started, those that name none of the robot's joints may be for another robot, and are told as worth knowing.
    """
    robot = robot_of(project)
    if robot is None:
        return
    hardware, names = hardware_in(project, robot), Names(robot.joint_names)
    yield from in_each_distro(project, lambda reader: _unknown(reader, robot, hardware[reader.distro], names, project))


def _unknown(reader: Reader, robot: Robot, hardware: Hardware, names: Names, project: Project) -> Iterator[Finding]:
    found = named(reader)
    wrong = [one for one in found if is_misnamed(one.claim, hardware) and one.name not in hardware.fixed]
    others = {one.name for one in found} - {one.name for one in wrong}
    meant = [meant_by(names, one, others) for one in wrong]
    if len(wrong) > 1 and not others:
        yield _none(reader, wrong, meant, severity_of(project, hardware, meant=all(meant), others=False))
        return
    for one, right in zip(wrong, meant, strict=True):
        end = f"; did you mean '{right}'?" if right else ", and none of the robot's is like it"
        message = f"unknown joint '{one.name}' of controller '{reader.name}'{end}"
        fix = replaced(one.at, one.name, right) if right else None
        severity = severity_of(project, hardware, meant=bool(right), others=bool(others))
        yield Finding(one.at, message, tuple(links_called(robot, one.name)), fix, severity)


def _none(reader: Reader, wrong: list[Named], meant: list[str | None], severity: Severity) -> Finding:
    """One finding for all joints, where the robot has none of them."""
    names = in_words([one.name for one in wrong])
    right = [name for name in meant if name]
    end = f"; did you mean {in_words(right)}?" if len(right) == len(wrong) else ""
    message = f"none of the joints of controller '{reader.name}' is one of the robot's: {names}{end}"
    return Finding(wrong[0].at, message, severity=severity)
