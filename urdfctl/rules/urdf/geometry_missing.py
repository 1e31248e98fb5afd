"""UC140."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in


@rule(
    "UC140",
    severity=Severity.WARNING,
    runtime="warns",
    authority="urdfdom urdf_parser/src/link.cpp parseGeometry(): 'Geometry tag contains no child element.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
                  «<collision>»
                    <origin xyz="0 0 0.1"/>
                  </collision>
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
                  <collision>
                    <origin xyz="0 0 0.1"/>
                    <geometry><box size="0.1 0.1 0.2"/></geometry>
                  </collision>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def geometry_missing(project: Project) -> Iterator[Finding]:
    """<visual> or <collision> without a shape.

    urdfdom prints an error, drops it and everything after it in the link, and continues.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        for geometry in link.geometries:
            if geometry.shape is None:
                message = (
                    f"<{geometry.role}> of {label('link', link.name)} has no <geometry> with a shape; it is dropped"
                )
                yield Finding(geometry.at, message)
