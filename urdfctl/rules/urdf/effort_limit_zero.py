"""UC161."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.limited_joints import held_by
from urdfctl.model.robot import Robot
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.written import at_value

_WRIST = """
    <link name="tool">
      <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
    </link>
    <joint name="wrist" type="revolute">
      <parent link="fore"/><child link="tool"/>
      <limit lower="-1" upper="1" effort="%s" velocity="2"/>
    </joint>
    <ros2_control name="arm" type="system">
      <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
      <joint name="wrist"><command_interface name="effort"/><state_interface name="position"/></joint>
    </ros2_control>
"""


def _in_gz(effort: str) -> str:
    """The robot in gz, commanded by position."""
    position = _WRIST.replace('command_interface name="effort"', 'command_interface name="position"')
    return position.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem") % effort


@rule(
    "UC161",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="joint_limits_interface EffortJointSaturationHandle clamps each command to the URDF's effort; Gazebo Classic "
    "physics/Joint.cc CheckAndTruncateForce() truncates it to an effort limit that is not negative; gz: DART "
    "ServoMotorConstraint::update() takes it as the strength of the servo; gazebo_ros_control default_robot_hw_sim.cpp: fmax",
    bad=[{"robot.urdf": _WRIST % "«0»"}, {"robot.urdf": _in_gz("«0»")}],
    good=[
        {"robot.urdf": _WRIST % "10"},
        {"robot.urdf": _WRIST.replace('command_interface name="effort"', 'command_interface name="position"') % "0"},
        {
            "robot.urdf": _WRIST % "0",
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """,
        },
    ],
)
def effort_limit_zero(project: Project) -> Iterator[Finding]:
    """Commanded joint has an effort limit of 0.

    Everything loads, but the joint never moves, and no message says why. An effort that is commanded is limited to 0. gz moves
    a joint by a servo of this strength, also if its position or velocity is commanded; gazebo_ros_control if its velocity is.
    It is an error if one of them, or a controller manager from kilted on, runs the robot. Other hardware that is commanded by
    position or velocity does not use the limit, and many well-kept robots have one of 0; nor is a passive joint reported, which
    no controller commands.
    """
    robot = robot_in(project)
    by_effort = _by_effort(robot) if robot else set()
    commanded = _commanded(project)
    for joint in robot.joints if robot else ():
        effort = joint.limit.effort if joint.limit else None
        if not effort or effort.value != 0 or not joint.moves or joint.mimic:
            continue
        if commanded is not None and joint.name not in commanded:
            continue
        holder = held_by(project, joint.name, "effort")
        if holder or joint.name in by_effort:
            reason = f"{holder} never moves the joint" if holder else "it is commanded by effort, and never moves"
            message = f"effort limit of {label('joint', joint.name)} is 0; {reason}"
            yield at_value(project, effort.at, message, severity=Severity.ERROR if holder else None)


def _by_effort(robot: Robot) -> set[str]:
    """The names of the joints whose only command is an effort."""
    names = {
        end.name
        for transmission in robot.transmissions
        for end in transmission.joints
        if end.interfaces and all(one.value.rpartition("/")[2] == "EffortJointInterface" for one in end.interfaces)
    }
    for component in robot.ros2_controls:
        for part in component.parts:
            if part.kind == "joint" and {command.name for command in part.commands} == {"effort"}:
                names.add(part.name)
    return {name for name in names if name}


def _commanded(project: Project) -> set[str] | None:
    """The joints that any controller commands; None if that is not known, or if there are no controllers."""
    controllers = project.controllers
    if controllers is None or not controllers.complete or not controllers.controllers:
        return None
    from urdfctl.control.session import sessions

    every = [configured for session in sessions(project) for configured in session.controllers]
    if any(configured.type is None for configured in every):
        return None
    return {claim.component for configured in every for claim in configured.claims.command}
