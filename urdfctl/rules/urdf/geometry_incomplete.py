"""UC142."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.common import lacking

REQUIRED = {"box": ("size",), "cylinder": ("length", "radius"), "sphere": ("radius",), "mesh": ("filename",)}


@rule(
    "UC142",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom urdf_parser/src/link.cpp: 'Cylinder shape must have both length and radius attributes', "
    "'Box shape has no size attribute', 'Mesh must contain a filename attribute'",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry>«<cylinder radius="0.1"/>»</geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry>«<box/>»</geometry></visual>
                  <visual><geometry>«<cylinder/>»</geometry></visual>
                  <visual><geometry>«<cylinder length="1"/>»</geometry></visual>
                  <collision><geometry>«<sphere/>»</geometry></collision>
                  <collision><geometry>«<mesh/>»</geometry></collision>
                  <collision><geometry><mesh filename="«»"/></geometry></collision>
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
                    <geometry><cylinder radius="0.1" length="0.2"/></geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def geometry_incomplete(project: Project) -> Iterator[Finding]:
    """Shape without dimensions, or mesh without a file.

    urdfdom prints an error, drops the visual or collision and everything after it in the link, and continues.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        for geometry in link.geometries:
            shape = geometry.shape
            missing = lacking(shape, REQUIRED.get(shape.name, ())) if shape else ""
            if shape is not None and missing:
                message = (
                    f"<{shape.name}> of {label('link', link.name)} has no {missing}; the <{geometry.role}> is dropped"
                )
                yield Finding(shape.at, message)
            elif shape is not None and shape.name == "mesh" and not shape.attributes["filename"]:
                yield Finding(shape.at["filename"], f"<mesh> of {label('link', link.name)} has an empty 'filename'")
