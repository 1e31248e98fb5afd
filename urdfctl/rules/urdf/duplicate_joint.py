"""UC111."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.common import duplicates


@rule(
    "UC111",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): \"joint '...' is not unique.\"",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="«elbow»" type="fixed"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool"/>
                <joint name="flange" type="fixed"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def duplicate_joint(project: Project) -> Iterator[Finding]:
    """Duplicate joint name.

    urdfdom rejects the whole robot.
    """
    robot = robot_in(project)
    if robot is not None:
        yield from duplicates("joint", ((part.name, part.at) for part in robot.joints))
