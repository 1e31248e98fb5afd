"""UC143."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.urdf.common import label, robot_in
from urdfctl.rules.urdf.numbers import Numbers


@rule(
    "UC143",
    severity=Severity.WARNING,
    authority="urdfdom urdf_parser/src/link.cpp compares nothing; sdformat src/Box.cc, src/Sphere.cc: sizes are positive",
    bad={
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
    good={
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
)
def geometry_not_positive(project: Project) -> Iterator[Finding]:
    """A measure of a shape is negative or 0.

    urdfdom takes it; what displays or simulates the shape refuses it, or shows and touches nothing. A mesh may have a
    negative scale, which mirrors it.
    """
    robot = robot_in(project)
    if robot is None:
        return
    numbers = Numbers(robot)
    for link in robot.links:
        for field, part in numbers.of_link(link):
            shape = field.element.name
            flat = shape == "mesh" and field.attribute == "scale" and 0.0 in field.values
            if flat or (shape in ("box", "cylinder", "sphere") and any(value <= 0 for value in field.values)):
                message = f"{field.label} in a <{part}> of {label('link', link.name)} is '{field.shown}', not positive"
                yield Finding(field.element.at[field.attribute], message)
