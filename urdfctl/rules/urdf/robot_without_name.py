"""UC102."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in


@rule(
    "UC102",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): 'No name given for the robot.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<robot>»
                  <link name="base"/>
                </robot>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <robot name="arm">
                  <link name="base"/>
                </robot>
            """,
        },
    ],
)
def robot_without_name(project: Project) -> Iterator[Finding]:
    """Robot without a name.

    urdfdom rejects the robot. It accepts an empty name, but sdformat, and so Gazebo, does not.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    if robot.name is None:
        yield Finding(robot.at, "<robot> has no 'name'")
    elif not robot.name:
        yield Finding(robot.at["name"], "<robot> has an empty 'name'; Gazebo rejects it", severity=Severity.WARNING)
