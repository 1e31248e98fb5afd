"""UC161."""

from __future__ import annotations

from collections.abc import Iterator

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


@rule(
    "UC161",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="joint_limits_interface EffortJointSaturationHandle clamps each command to the URDF's effort; Gazebo Classic "
    "physics/Joint.cc CheckAndTruncateForce() truncates it to an effort limit that is not negative",
    bad=[{"robot.urdf": _WRIST % "«0»"}],
    good=[
        {"robot.urdf": _WRIST % "10"},
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
    """Joint that is commanded by effort has an effort limit of 0.

    Everything loads, but each effort is limited to 0: the joint never moves, and no message says why. For a joint that
    is commanded by position or velocity only, the limit is not reported: many well-kept robots have one of 0; nor for a
    passive joint, which no controller commands.
    """
    robot = robot_in(project)
    driven = _by_effort(robot) if robot else set()
    commanded = _commanded(project)
    if commanded is not None:
        driven &= commanded
    for joint in robot.joints if robot else ():
        effort = joint.limit.effort if joint.limit else None
        if effort and effort.value == 0 and joint.moves and joint.name in driven and not joint.mimic:
            message = (
                f"effort limit of {label('joint', joint.name)} is 0, but it is commanded by effort: it never moves"
            )
            yield at_value(project, effort.at, message)


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
