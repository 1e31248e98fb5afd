"""UC158."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Link
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, whole_robot_in
from urdfctl.rules.urdf.bodies import LEAST_MASS, Body, bodies, inertial_of, mass_of
from urdfctl.rules.urdf.common import severity_in_gazebo
from urdfctl.rules.urdf.inertia import moments_of, principal_moments
from urdfctl.rules.urdf.tree import parent_of


@rule(
    "UC158",
    runtime="misbehaves",
    severity=Severity.WARNING,
    authority="sdformat accepts moments of 0; dartsim dynamics/Inertia.cpp verifyMoment(): 'Invalid entry for (0,0): 0. "
    "Value should be positive and greater than zero.'",
    whole_robot=True,
    bad=[
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1"/>«<inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>»</inertial>
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
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
                <link name="tip">
                  <inertial><mass value="0.1"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial>
                </link>
                <joint name="tip_joint" type="fixed"><parent link="tool"/><child link="tip"/></joint>
            """,
        },
        {
            "robot.urdf": """
                <link name="tool">
                  <inertial><mass value="1e-5"/><inertia ixx="1e-35" ixy="0" ixz="0" iyy="1e-35" iyz="0" izz="1e-35"/></inertial>
                </link>
                <joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>
            """,
        },
    ],
)
def inertia_zero(project: Project) -> Iterator[Finding]:
    """Moving link with mass, but with a moment of inertia of 0.

    No body with mass has a moment of 0. Readers accept it, but physics engines divide by it: the joint explodes or the
    robot disappears. A link with such an inertia is harmless if it is fixed to a link with a larger one. This is an
    error if the robot certainly runs in gz, unless the link carries another one that has an inertia.
    """
    robot = whole_robot_in(project)
    if robot is None or not project.may_be_simulated:
        return
    everything = bodies(robot)
    carried = {parent_of(body.joint) for body in everything if body.joint and not _flat_link(body)}
    for body in everything:
        link = _flat_link(body) if body.joint and body.joint.moves else None
        inertial = inertial_of(link) if link else None
        if link and inertial and inertial.inertia_at:
            is_alone = not carried & {part.name for part in body.links}
            severity = severity_in_gazebo(project, refused_by=("gz",) if is_alone else ())
            message = f"<inertia> of {label('link', link.name)} has a moment of 0, but the link moves and has mass; "
            yield Finding(inertial.inertia_at, message + "compute it from the link's shape", severity=severity)


def _flat_link(body: Body) -> Link | None:
    """The first link with mass of a body in which all of them have a moment of 0; None for other bodies."""
    heavy = [link for link in body.links if mass_of(link) > LEAST_MASS]
    return heavy[0] if heavy and all(_is_flat(link) for link in heavy) else None


def _is_flat(link: Link) -> bool:
    """Whether a principal moment of a possible inertia is 0. UC136 reports impossible ones."""
    moments = moments_of(inertial_of(link))
    if moments is None:
        return False
    least, middle, most = principal_moments(moments)
    return abs(least) <= 1e-12 * abs(most) and (least + middle) >= most * (1 - 1e-6)
