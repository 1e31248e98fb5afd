"""UC143."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.numbers import VECTOR, Field

MEASURES = {
    "box": (("size", VECTOR),),
    "cylinder": (("length", 1), ("radius", 1)),
    "sphere": (("radius", 1),),
    "mesh": (("scale", VECTOR),),
}
"""The attributes with a shape's dimensions, and how many numbers each has."""


@rule(
    "UC143",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom urdf_parser/src/link.cpp does not check sizes; sdformat src/Box.cc, src/Sphere.cc: sizes must be positive",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry><sphere radius="«-0.1»"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry><box size="«1 0 1»"/></geometry></visual>
                  <visual><geometry><cylinder length="«0»" radius="«-1»"/></geometry></visual>
                  <collision><geometry><mesh filename="file:///tool.stl" scale="«1 1 0»"/></geometry></collision>
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
                    <geometry><sphere radius="0.1"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry><mesh filename="package://arm/tool.stl" scale="1 -1 1"/></geometry></visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
            "package.xml": '<package format="3"><name>arm</name></package>',
            "tool.stl": "solid tool",
        },
    ],
)
def geometry_not_positive(project: Project) -> Iterator[Finding]:
    """Shape dimension is zero or negative.

    urdfdom accepts it. Viewers and simulators leave out the shape: it is invisible and touches nothing. A mesh may have
    a negative scale, which mirrors it.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        for geometry in link.geometries:
            shape = geometry.shape
            for name, size in MEASURES.get(shape.name, ()) if shape else ():
                text = shape.attributes.get(name, "") if shape else ""
                values = Field(shape, name, text, size).values if shape else []
                if any(value == 0 if name == "scale" else value <= 0 for value in values) and shape:
                    part = f"a <{geometry.role}> of {label('link', link.name)}"
                    must = "must not be 0" if name == "scale" else "must be positive"
                    yield Finding(shape.at[name], f"'{name}' of <{shape.name}> in {part} {must}: '{text}'")
