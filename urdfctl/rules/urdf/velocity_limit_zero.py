"""UC131."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.limited_joints import held_by
from urdfctl.model.robot import Limit
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.common import commanded_joints
from urdfctl.rules.written import at_value


@rule(
    "UC131",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="joint_limits_interface and joint_limits joint_range_limiter.cpp limit commands to the URDF's velocity; gz-physics "
    "dartsim/src/SDFFeatures.cc; ros2_control_demos#787: carlikebot's steering did not move in Gazebo",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="10" velocity="«0»"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="wrist"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                </joint>
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="wrist"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def velocity_limit_zero(project: Project) -> Iterator[Finding]:
    """Commanded joint has a velocity limit of 0.

    Everything loads, but the joint never moves, and no message says why: gz, gazebo_ros_control, and from kilted on the
    controller manager, limit each command to this velocity. It is an error if one of them runs the robot. Elsewhere the joint
    moves, but MoveIt does not plan for it. In a macro library it is unknown which joints are commanded, so joints with an
    effort and a range are reported.
    """
    robot = robot_in(project)
    if robot is None:
        return
    commanded = commanded_joints(robot)
    for joint in robot.joints:
        velocity = joint.limit.velocity if joint.limit else None
        if not velocity or velocity.value != 0 or not joint.moves:
            continue
        what = f"velocity limit of {label('joint', joint.name)} is 0"
        if joint.name in commanded and not joint.mimic:
            holder = held_by(project, joint.name, "velocity")
            message = f"{what}; {holder or 'whoever applies it'} never moves the joint"
            yield at_value(project, velocity.at, message, severity=Severity.ERROR if holder else None)
        elif project.library and joint.limit and _may_move(joint.limit):
            yield at_value(project, velocity.at, f"{what}; if commanded, the joint never moves")


def _may_move(limit: Limit) -> bool:
    """Whether the limit looks like that of a driven joint: it has an effort and a range."""
    effort, lower, upper = (number.value if number else None for number in (limit.effort, limit.lower, limit.upper))
    return bool(effort) and lower is not None and upper is not None and lower < upper
