"""UC104."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in


@rule(
    "UC104",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): 'No link elements found in urdf file'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<robot name="arm">»
                  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
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
def robot_without_links(project: Project) -> Iterator[Finding]:
    """Robot without links.

    urdfdom rejects the robot. A xacro file without links is assumed to be a part that other files include.
    """
    robot = whole_robot_in(project)
    if robot is not None and not robot.links:
        yield Finding(robot.at, "the robot has no <link>; add at least one")
