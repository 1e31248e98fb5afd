"""UC110."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.common import duplicates


@rule(
    "UC110",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): \"link '...' is not unique.\"",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="«fore»"/>
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
def duplicate_link(project: Project) -> Iterator[Finding]:
    """Duplicate link name.

    urdfdom rejects the whole robot.
    """
    robot = robot_in(project)
    if robot is not None:
        yield from duplicates("link", ((part.name, part.at) for part in robot.links))
