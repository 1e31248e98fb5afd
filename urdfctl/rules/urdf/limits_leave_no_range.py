"""UC132."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.limited_joints import held_by
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.common import commanded_joints


@rule(
    "UC132",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/joint.cpp parseJointLimits(): lower and upper default to 0",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  «<limit effort="10" velocity="2"/>»
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
def limits_leave_no_range(project: Project) -> Iterator[Finding]:
    """Commanded joint has no range of motion.

    A revolute or prismatic joint whose <limit> has neither lower nor upper can only be at 0. Everything loads, but the
    joint does not move. It is an error if a simulator, or from kilted on the controller manager, keeps the joint there.
    """
    robot = robot_in(project)
    if robot is None:
        return
    commanded = commanded_joints(robot)
    for joint in robot.joints:
        limit = joint.limit
        if limit is None or joint.type not in ("revolute", "prismatic") or joint.name not in commanded or joint.mimic:
            continue
        lower = 0.0 if limit.lower is None else limit.lower.value
        upper = 0.0 if limit.upper is None else limit.upper.value
        if lower is not None and lower == upper:
            problem = "has neither 'lower' nor 'upper'; both default to 0"
            if limit.lower or limit.upper:
                problem = f"leaves no range of motion: 'lower' and 'upper' are both {lower:g}"
            severity = Severity.ERROR if held_by(project, joint.name, "range") else None
            yield Finding(limit.at, f"<limit> of commanded {label('joint', joint.name)} {problem}", severity=severity)
