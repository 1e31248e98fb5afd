"""UC145."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, replaced, whole_robot_in
from urdfctl.rules.urdf.materials import materials_of


@rule(
    "UC145",
    runtime="warns",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/model.cpp assignMaterial(): \"link '...' material '...' undefined.\"",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    <material name="«gray»"/>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    <material name="grey"/>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def material_undefined(project: Project) -> Iterator[Finding]:
    """Undefined material.

    A material of the robot is known everywhere. A material that a visual defines is known only after it. urdfdom prints
    a warning, and the link has no colour.
    """
    robot = whole_robot_in(project)
    if robot is None:
        return
    materials = list(materials_of(robot))
    defined = {material.name for material in materials if material.link is None}
    names = KnownNames(material.name for material in materials if material.is_definition)
    for material in materials:
        name = material.name
        if material.is_definition:
            defined.add(name)
        elif name and name not in defined and is_known(name) and not material.tag.children:
            meant = None if name in names else names.meant_by(name)
            hint = f"; did you mean '{meant}'?" if meant else ""
            problem = "is used before it is defined" if name in names else f"is not defined{hint}"
            at = material.tag.at["name"]
            fix = replaced(at, name, meant) if meant else None
            yield Finding(at, f"{material.label} {problem}", fix=fix)
