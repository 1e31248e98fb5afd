"""UC146."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.urdf.materials import materials_of


@rule(
    "UC146",
    runtime="warns",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/model.cpp parseMaterial(): 'Material [...] color has no rgba', "
    "'Material [...] not defined in file'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                «<material name="grey">»<color value="0.5 0.5 0.5 1"/></material>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
            """,
        },
    ],
)
def material_without_colour(project: Project) -> Iterator[Finding]:
    """Material without a colour or texture.

    A material of the robot needs <color rgba="..."> or <texture filename="...">. Without them, urdfdom prints an error
    and keeps a material without an appearance. A material of a visual may be a bare name, which refers to another one.
    """
    robot = robot_in(project)
    for material in materials_of(robot) if robot else ():
        bare_reference = material.link is not None and not material.tag.children
        if not bare_reference and not material.colour and not material.texture:
            message = f'{material.label} has neither <color rgba="..."/> nor <texture filename="..."/>'
            yield Finding(material.tag.at, message)
