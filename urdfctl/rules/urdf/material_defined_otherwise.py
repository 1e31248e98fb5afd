"""UC148."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in
from urdfctl.rules.urdf.materials import Material, materials_of


@rule(
    "UC148",
    runtime="ignores",
    because="only a colour differs",
    severity=Severity.INFO,
    authority="urdfdom urdf_parser/src/model.cpp assignMaterial(): a known material of the same name replaces the visual's own",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <material name="paint"><color rgba="0 0 1 1"/></material>
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    <material name="«paint»"><color rgba="1 0 0 1"/></material>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <material name="paint"><color rgba="0 0 1 1"/></material>
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><box size="0.1 0.1 0.1"/></geometry>
                    <material name="red_paint"><color rgba="1 0 0 1"/></material>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def material_defined_otherwise(project: Project) -> Iterator[Finding]:
    """Material is already defined differently.

    The first definition of a name applies everywhere. This one is silently ignored.
    """
    robot = robot_in(project)
    first: dict[str, Material] = {}
    for material in materials_of(robot) if robot else ():
        looks = material.looks
        if not material.name or looks == (None, None) or not is_known(material.name, *looks):
            continue
        before = first.setdefault(material.name, material)
        if material.link is not None and before.looks != looks:
            message = f"{material.label} is ignored: an earlier definition of this name looks different"
            yield Finding(
                material.tag.at["name"], message, (Note("the earlier definition is here", before.tag.at["name"]),)
            )
