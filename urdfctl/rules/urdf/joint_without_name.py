"""UC109."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in


@rule(
    "UC109",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/joint.cpp parseJoint(): 'unnamed joint found'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                «<joint type="fixed">»
                  <parent link="fore"/><child link="tool"/>
                </joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed">
                  <parent link="fore"/><child link="tool"/>
                </joint>
            """,
        },
    ],
)
def joint_without_name(project: Project) -> Iterator[Finding]:
    """Joint without a name.

    urdfdom rejects the whole robot. It accepts an empty name, but sdformat, and so Gazebo, does not.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.name is None:
            yield Finding(joint.at, "<joint> has no 'name'")
        elif not joint.name:
            message = "<joint> has an empty 'name'; Gazebo rejects it"
            yield Finding(joint.at["name"], message, severity=Severity.WARNING)
