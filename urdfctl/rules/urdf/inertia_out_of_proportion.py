"""UC137."""

from __future__ import annotations

import math
from collections.abc import Iterator

from urdfctl.model.parts import Number
from urdfctl.model.robot import Link
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, robot_in
from urdfctl.rules.urdf.bodies import LEAST_MASS, inertial_of, mass_of
from urdfctl.rules.urdf.inertia import moments_of, principal_moments
from urdfctl.rules.urdf.numbers import VECTOR, Field

LARGEST_REACH = 10.0
"""In m: no robot's link has its mass so far from its centre."""
LARGER, SMALLER = 10.0, 0.001
"""How far the radius of gyration may be from a link's own size."""


@rule(
    "UC137",
    severity=Severity.INFO,
    authority="the moment of a body of mass m whose mass lies r from its centre is m r²; Gazebo's tutorial on inertia",
    bad={
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
    good={
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
)
def inertia_out_of_proportion(project: Project) -> Iterator[Finding]:
    """An inertia is out of all proportion to the link's mass and size.

    Such a joint turns as if it were held, or trembles. Mostly the moments are in g mm² or a placeholder.
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
        reach, size = math.sqrt(most / mass), _size(link)
        what = f"the inertia of {label('link', link.name)}, {most:g} kg m² at {mass:g} kg,"
        if reach > LARGEST_REACH or (size and reach > LARGER * size):
            told = f"; the link is {size:g} m large" if size else ""
            yield Finding(inertial.inertia_at, f"{what} is that of a body {2 * reach:.3g} m wide{told}")
        elif size and reach < SMALLER * size:
            message = f"{what} is that of a body {2 * reach:.3g} m wide; the link is {size:g} m large"
            yield Finding(inertial.inertia_at, message)


def _size(link: Link) -> float | None:
    """The greatest extent of a link in m, by its shapes; None where one is a mesh or cannot be read."""
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
