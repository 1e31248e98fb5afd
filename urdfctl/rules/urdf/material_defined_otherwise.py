"""UC148."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known, robot_in
from urdfctl.rules.urdf.materials import Material, materials_of


@rule(
    "UC148",
    severity=Severity.INFO,
    authority="urdfdom urdf_parser/src/model.cpp assignMaterial(): a material that is known by its name replaces the visual's own",
    whole_robot=True,
    bad={
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
    good={
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
)
def material_defined_otherwise(project: Project) -> Iterator[Finding]:
    """A visual defines a material that already looks otherwise.

    The first definition of a name holds for all: this one is not seen, and nothing is said.
    """
    robot = robot_in(project)
    first: dict[str, Material] = {}
    for material in materials_of(robot) if robot else ():
        looks = material.looks
        if not material.name or looks == (None, None) or not is_known(material.name, *looks):
            continue
        before = first.setdefault(material.name, material)
        if material.link is not None and before.looks != looks:
            message = f"{material.label} is defined otherwise before, and that definition holds"
            yield Finding(material.tag.at["name"], message, (Note("it is here", before.tag.at["name"]),))
