"""UC440."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial

from urdfctl.control.hardware.interfaces import OfferedHardware
from urdfctl.control.parameters.readers import Reader, in_each_distro, readers_of, robot_of
from urdfctl.control.unknown_joint_claims import is_misnamed
from urdfctl.model.robot import Robot
from urdfctl.names import are_opposed, folded, in_row, is_slip
from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.common import KnownNames, in_words, is_known, replaced, robot_in
from urdfctl.rules.controllers.joints import Named, hardware_in, looks_joints_up, meant_by, named, severity_of
from urdfctl.rules.links_for_joints import joint_meant_by, links_called

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
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_controllers: 'Could not find joint 'elbw' in URDF model.', 'Could not find resource 'elbw' in "
    "'hardware_interface::PositionJointInterface'.'; ros2_control: 'Unable to activate controller 'arm' since the command "
    "interface 'elbw/position' is not available.'",
    in_library=False,
    options=["--distro=jazzy"],
    bad=[
        {"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«elbw»"},
        {"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "«lift»"},
        {
            "robot.urdf": """
                <robot name="hand">
                  <link name="base"/>
                  <link name="left_arm_wrist_joint_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="left_arm_wrist_joint" type="continuous"><parent link="base"/><child link="left_arm_wrist_joint_link"/></joint>
                  <link name="front_laser_turret_joint_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="front_laser_turret_joint" type="continuous"><parent link="base"/><child link="front_laser_turret_joint_link"/></joint>
                  <link name="l_ankle_pitch_joint_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="l_ankle_pitch_joint" type="continuous"><parent link="base"/><child link="l_ankle_pitch_joint_link"/></joint>
                  <link name="upper_jaw_hinge_joint_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="upper_jaw_hinge_joint" type="continuous"><parent link="base"/><child link="upper_jaw_hinge_joint_link"/></joint>
                  <link name="top_drawer_slider_joint_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="top_drawer_slider_joint" type="continuous"><parent link="base"/><child link="top_drawer_slider_joint_link"/></joint>
                  <link name="thumb_link"><inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial></link>
                  <joint name="thumb" type="continuous"><parent link="base"/><child link="thumb_link"/></joint>
                  <ros2_control name="hand" type="system">
                    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                    <joint name="left_arm_wrist_joint"><command_interface name="position"/><state_interface name="position"/></joint>
                    <joint name="front_laser_turret_joint"><command_interface name="position"/><state_interface name="position"/></joint>
                    <joint name="l_ankle_pitch_joint"><command_interface name="position"/><state_interface name="position"/></joint>
                    <joint name="upper_jaw_hinge_joint"><command_interface name="position"/><state_interface name="position"/></joint>
                    <joint name="top_drawer_slider_joint"><command_interface name="position"/><state_interface name="position"/></joint>
                    <joint name="thumb"><command_interface name="position"/><state_interface name="position"/></joint>
                  </ros2_control>
                </robot>
            """,
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
                    hand: {type: forward_command_controller/ForwardCommandController}
                hand:
                  ros__parameters:
                    joints: [thumb, «right_arm_wrist_joint», «rear_laser_turret_joint», «r_ankle_pitch_joint», «lower_jaw_hinge_joint», «bottom_drawer_slider_joint»]
                    interface_name: position
            """,
        },
    ],
    good=[{"robot.urdf": _ROBOT, "controllers.yaml": _CONTROLLERS % "elbow"}],
)
def controller_joint_unknown(project: Project) -> Iterator[Finding]:
    """Unknown joint in a controller.

    The controller is not loaded (ROS 1), or is loaded but cannot be activated (ROS 2). If it is unknown which
    controllers are started, a controller that names none of the robot's joints may be for another robot: it is reported
    as info. If a part of the robot is not here, only a name that is nearly one of the known joints is reported.
    """
    robot = robot_of(project)
    if robot is None:
        if not project.complete:
            yield from in_each_distro(project, lambda reader: _nearly(reader, _known_joints(project)))
        return
    hardware, names = hardware_in(project, robot), KnownNames(robot.joint_names)
    yield from in_each_distro(project, lambda reader: _unknown(reader, robot, hardware[reader.distro], names, project))


def _known_joints(project: Project) -> set[str]:
    """The joints of the part of a robot that is known, and of its components."""
    robot = robot_in(project)
    controls = robot.ros2_controls if robot else ()
    parts = [part.name or "" for control in controls for part in control.parts if part.kind == "joint"]
    return {name for name in (*(robot.joint_names if robot else ()), *parts) if name and is_known(name)}


def _nearly(reader: Reader, known: set[str]) -> Iterator[Finding]:
    """Yield the joints whose names are nearly those of known joints, which the controller does not name."""
    joints = named(reader)
    free = known - {joint.name for joint in joints}
    for joint in joints:
        near = [name for name in free if _is_near(joint.name, name)]
        if joint.name in known or len(near) != 1:
            continue
        message = f"controller '{reader.name}' names joint '{joint.name}', but the part of the robot that is here has '{near[0]}'"
        yield Finding(joint.at, message, fix=replaced(joint.at, joint.name, near[0]), severity=Severity.WARNING)


def _is_near(name: str, known: str) -> bool:
    """Whether a name is surely a slip for another one: another number or side may be a joint that is not here."""
    if re.findall(r"\d", name) != re.findall(r"\d", known) or are_opposed(name, known):
        return False
    return is_slip(name, known) or folded(name) == folded(known)


def _unknown(
    reader: Reader, robot: Robot, hardware: OfferedHardware, names: KnownNames, project: Project
) -> Iterator[Finding]:
    severity = partial(severity_of, project, hardware, looked_up=looks_joints_up(reader))
    named_joints = named(reader)
    unknown = [
        joint for joint in named_joints if is_misnamed(joint.claim, hardware) and joint.name not in hardware.fixed
    ]
    others = {joint.name for joint in named_joints} - {joint.name for joint in unknown}
    joints = [joint_meant_by(robot, joint.name, meant_by(names, joint, others), others) for joint in unknown]
    meant = [joint.name for joint in joints]
    left = _only_left(project, reader, hardware) if len(unknown) == 1 else None
    if len(unknown) > 1 and not others:
        yield _all_unknown(reader, unknown, meant, severity(meant=all(meant), others=False))
        return
    for joint, (right, is_sure) in zip(unknown, joints, strict=True):
        only = ""
        if right is None and left and not _are_of_one_row(joint.name, left):
            right, only = left, ", the only joint that no controller names"  # noqa: PLW2901 (what is meant then)
        hint = f"; did you mean '{right}'{only}?" if right else ""
        message = f"controller '{reader.name}' names joint '{joint.name}', which the robot does not have{hint}"
        is_sure = is_sure or names.is_sure(joint.name, right)  # noqa: PLW2901 (what is known of it then)
        fix = replaced(joint.at, joint.name, right, safe=is_sure) if right else None
        slip = is_sure and right in hardware.command
        notes = tuple(links_called(robot, joint.name))
        yield Finding(joint.at, message, notes, fix, severity(meant=bool(right), others=bool(others), slip=slip))


def _only_left(project: Project, reader: Reader, hardware: OfferedHardware) -> str | None:
    """The only joint with a command interface that no controller names; None if there are more, or none."""
    readers = (other for nodes in readers_of(project) for other in nodes if other.distro == reader.distro)
    taken = {joint.name for other in readers for joint in named(other)}
    free = [name for name in hardware.command if name in hardware.joints and name not in taken]
    return free[0] if len(free) == 1 else None


def _are_of_one_row(name: str, other: str) -> bool:
    """Whether two joints differ by their side or number: neither is written for the other."""
    return are_opposed(name, other) or in_row(name) == in_row(other)


def _all_unknown(reader: Reader, unknown: list[Named], meant: list[str | None], severity: Severity) -> Finding:
    """One finding for all joints of a controller, if the robot has none of them."""
    names = in_words([joint.name for joint in unknown])
    right = [name for name in meant if name]
    hint = f"; did you mean {in_words(right)}?" if len(right) == len(unknown) else ""
    message = f"controller '{reader.name}' names only joints that the robot does not have: {names}{hint}"
    return Finding(unknown[0].at, message, severity=severity)
