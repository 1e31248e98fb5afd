"""UC137."""

from __future__ import annotations

import math
from collections.abc import Iterator

from urdfctl.model.robot import Link, Number
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.bodies import LEAST_MASS, inertial_of, mass_of
from urdfctl.rules.urdf.inertia import moments_of, principal_moments
from urdfctl.rules.urdf.numbers import VECTOR, Field

LARGEST_REACH = 10.0
"""In m; no link of a robot has its mass this far from its centre."""
LARGER, SMALLER = 10.0, 0.001
"""Limits of the ratio of a link's radius of gyration to its size."""


@rule(
    "UC137",
    runtime="misbehaves",
    because="physics engines accept it, and the sizes are rough",
    severity=Severity.INFO,
    authority="the moment of a body of mass m whose mass lies r from its centre is m r²; Gazebo's tutorial on inertia",
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial>
                    <mass value="0.5"/>
                    «<inertia ixx="100" ixy="0" ixz="0" iyy="100" iyz="0" izz="100"/>»
                  </inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial>
                    <mass value="0.5"/>
                    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
                  </inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def inertia_out_of_proportion(project: Project) -> Iterator[Finding]:
    """Inertia does not fit the link's mass and size.

    The joint turns as if it were held, or it trembles. Usually the moments are in g mm², or they are placeholders.
    """
    robot = robot_in(project)
    for link in robot.links if robot else ():
        inertial, mass = inertial_of(link), mass_of(link)
        moments = moments_of(inertial)
        if inertial is None or inertial.inertia_at is None or moments is None or mass <= LEAST_MASS:
            continue
        most = principal_moments(moments)[2]
        if most <= 0:
            continue
        reach, size = math.sqrt(most / mass), size_of(link)
        if reach > LARGEST_REACH or (size and (reach > LARGER * size or reach < SMALLER * size)):
            body = f"a body {2 * reach:.3g} m wide ({most:g} kg m² at {mass:g} kg)"
            actual = f", but the link is {size:g} m wide" if size else ""
            yield Finding(inertial.inertia_at, f"<inertia> of {label('link', link.name)} fits {body}{actual}")


def size_of(link: Link) -> float | None:
    """Return the largest dimension of a link's shapes in m; None if one is a mesh or cannot be read."""
    extents = []
    for geometry in link.geometries:
        shape = geometry.shape
        if shape is None:
            return None
        if shape.name == "box":
            sizes = Field(shape, "size", shape.attributes.get("size", ""), VECTOR).values
        else:
            numbers = [Number(shape.attributes.get(name, ""), shape.at, name).value for name in ("radius", "length")]
            sizes = [2 * (numbers[0] or 0), numbers[1] or 0]
        if shape.name not in ("box", "cylinder", "sphere") or not sizes:
            return None
        extents.append(max(sizes))
    return max(extents, default=None) or None
