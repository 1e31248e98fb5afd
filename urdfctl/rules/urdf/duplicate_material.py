"""UC112."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.common import duplicates


@rule(
    "UC112",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="urdfdom urdf_parser/src/model.cpp parseURDF(): \"material '...' is not unique.\"",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
                <material name="«grey»"><color rgba="0.5 0.5 0.5 1"/></material>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
                <material name="dark_grey"><color rgba="0.3 0.3 0.3 1"/></material>
            """,
        },
    ],
)
def duplicate_material(project: Project) -> Iterator[Finding]:
    """Duplicate material name.

    urdfdom rejects the whole robot, even if both materials have the same colour. Often a file of materials is included
    twice. Materials inside a <visual> may repeat a name.
    """
    robot = robot_in(project)
    if robot is None:
        return
    materials = (tag for tag in robot.others if tag.name == "material")
    yield from duplicates("material", ((tag.attributes.get("name", ""), tag.at) for tag in materials))
