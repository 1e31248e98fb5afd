"""UC141."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import enumerated, nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, respelt, robot_in

SHAPES = ("box", "cylinder", "sphere", "mesh")


@rule(
    "UC141",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom urdf_parser/src/link.cpp parseGeometry(): \"Unknown geometry type '...'\"",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual>
                    <geometry>«<capsule radius="0.1" length="0.2"/>»</geometry>
                  </visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry>«<sphear radius="1"/>»</geometry></visual>
                  <visual><geometry>«<boxx size="1 1 1"/>»</geometry></visual>
                  <visual><geometry>«<cylindre length="1" radius="1"/>»</geometry></visual>
                  <collision><geometry>«<mehs filename="a.stl"/>»</geometry></collision>
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
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  <visual><geometry><sphere radius="1"/></geometry></visual>
                  <visual><geometry><box size="1 1 1"/></geometry></visual>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def geometry_unknown(project: Project) -> Iterator[Finding]:
    """Unknown shape.

    urdfdom knows box, cylinder, sphere and mesh. For any other shape it prints an error, drops the visual or collision
    and everything after it in the link, and continues.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        for geometry in link.geometries:
            shape = geometry.shape
            if shape is not None and shape.name not in SHAPES:
                meant = nearest(shape.name, SHAPES)
                hint = f"did you mean '{meant}'?" if meant else f"use {enumerated(SHAPES, 'or')}"
                message = f"<{geometry.role}> of {label('link', link.name)} has unknown shape <{shape.name}>; {hint}"
                yield Finding(shape.at, message, fix=respelt(shape, meant))
