"""UC108."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in


@rule(
    "UC108",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/link.cpp: 'No name given for the link.', then model.h: 'Two root links found: [] and [a]'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<link/>»
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
def link_without_name(project: Project) -> Iterator[Finding]:
    """Link without a name.

    urdfdom keeps it under the empty name. No joint can refer to it, so it is a second root, and urdfdom rejects the
    whole robot.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        if not link.name:
            severity = Severity.WARNING if robot and len(robot.links) == 1 else None
            problem = "has no 'name'" if link.name is None else "has an empty 'name'"
            yield Finding(link.at["name"], f"<link> {problem}; no joint can refer to it", severity=severity)
