"""UC109."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in


@rule(
    "UC109",
    severity=Severity.ERROR,
    authority="urdfdom urdf_parser/src/joint.cpp parseJoint(): 'unnamed joint found'",
    whole_robot=True,
    bad={
        "robot.urdf": """
            <link name="tool"/>
            «<joint type="fixed">»
              <parent link="fore"/><child link="tool"/>
            </joint>
        """,
    },
    good={
        "robot.urdf": """
            <link name="tool"/>
            <joint name="flange" type="fixed">
              <parent link="fore"/><child link="tool"/>
            </joint>
        """,
    },
)
def joint_without_name(project: Project) -> Iterator[Finding]:
    """A joint has no name.

    urdfdom gives no model for the whole robot. An empty name it takes, but sdformat, and so Gazebo, does not.
    """
    robot = robot_in(project)
    for joint in robot.joints if robot else ():
        if joint.name is None:
            yield Finding(joint.at, "<joint> has no 'name'")
        elif not joint.name:
            message = "the name of <joint> is empty; Gazebo refuses it"
            yield Finding(joint.at["name"], message, severity=Severity.WARNING)
