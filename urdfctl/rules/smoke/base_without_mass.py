"""UC958."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS


@fault(
    "UC958",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="sdformat's parser_urdf.cc: a link without <inertial> adds no mass to the link that it is joined to",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('<link name="base_link">', '«<link name="base_link">»').replace(
                '<inertial><mass value="5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>',
                "",
            ),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def base_without_mass(link: str, rest: str) -> str:
    """Base of a mobile robot without mass.

    Simulators add no mass for its shape: the base is far too light, and the robot jumps or slips.
    """
    return f"link '{link}' is the largest part of the robot's base, but has no mass; the rest of the base has {rest} kg"
