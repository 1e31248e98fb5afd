"""UC124."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.common import lacking


@rule(
    "UC124",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJointLimits(): 'joint limit: no effort', 'joint limit: no velocity'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                </link>
                <joint name="wrist" type="revolute">
                  <parent link="fore"/><child link="tool"/>
                  «<limit lower="-1" upper="1" effort="10"/>»
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
def limit_incomplete(project: Project) -> Iterator[Finding]:
    """Joint limit without effort or velocity.

    urdfdom requires both in every <limit>, even of fixed and continuous joints. Without them it rejects the whole
    robot.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        limit = next(joint.tag.named("limit"), None)
        missing = lacking(limit, ("effort", "velocity")) if limit else ""
        if limit and missing:
            yield Finding(limit.at, f"<limit> of {label('joint', joint.name)} has no {missing}")
