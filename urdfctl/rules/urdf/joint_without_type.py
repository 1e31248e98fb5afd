"""UC120."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC120",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJoint(): 'joint [...] has no type, check to see if it's a reference.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                «<joint name="wrist">»
                  <parent link="fore"/><child link="tool"/>
                  <limit lower="-1" upper="1" effort="10" velocity="2"/>
                </joint>
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
            """,
        },
    ],
)
def joint_without_type(project: Project) -> Iterator[Finding]:
    """Joint without a type.

    urdfdom rejects the whole robot.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.type is None:
            yield Finding(joint.at, f"{label('joint', joint.name)} has no 'type'")
