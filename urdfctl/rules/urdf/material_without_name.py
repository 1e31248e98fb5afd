"""UC144."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Tag
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.source.span import SourceSpan


@rule(
    "UC144",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom urdf_parser/src/link.cpp: 'Visual material must contain a name attribute', "
    "'Material must contain a name attribute'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    «<material>»<color rgba="0.5 0.5 0.5 1"/></material>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def material_without_name(project: Project) -> Iterator[Finding]:
    """Material without a name.

    urdfdom prints an error and drops the visual that contains it, and everything after it in the link. It accepts an
    empty name.
    """
    robot = robot_in(project)
    if robot is None:
        return
    for tag in robot.others:
        if tag.name == "material" and "name" not in tag.attributes:
            yield Finding(tag.at, "<material> of the robot has no 'name', so no link can refer to it")
    for link in robot.links:
        for visual in link.tag.named("visual"):
            material = _first_material(visual)
            if material is not None and "name" not in material.attributes:
                message = f"<material> of {label('link', link.name)} has no 'name'; its <visual> is dropped"
                yield Finding(material.at, message, fix=_fix(material))


def _fix(material: Tag) -> Fix | None:
    """An empty name is enough for a material that defines its own appearance."""
    if not any(material.named("color")) and not any(material.named("texture")):
        return None
    at = material.at.source, material.at.start + len("<material")
    return Fix('write <material name="">; it is used only here', (Edit(SourceSpan(*at, at[1]), ' name=""'),), safe=True)


def _first_material(visual: Tag) -> Tag | None:
    return next(visual.named("material"), None)
