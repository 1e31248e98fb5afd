"""UC976."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left

_SURFACE = "".join(f'<gazebo reference="{name}"><mu1>%s</mu1><mu2>%s</mu2></gazebo>' for name in ("left", "right"))


@fault(
    "UC976",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="Coulomb friction: a contact with the load N pushes with at most mu N; sdformat parser_urdf.cc reads <mu1> and <mu2>",
    explains=(does_not_drive_forward, does_not_turn_left),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace("</robot>", f"{_SURFACE % (0, 0, 0, 0)}</robot>"),
            "controllers.yaml": WHEELS % "«base»",
        },
    ],
    good=[
        {
            "robot.urdf": ROVER.replace("</robot>", f"{_SURFACE % (0.9, 0.9, 0.9, 0.9)}</robot>"),
            "controllers.yaml": WHEELS % "base",
        },
    ],
)
def wheels_slip(controller: str, thrust: str, needed: str) -> str:
    """Wheels that slip on the ground.

    The friction of the driven wheels, times the weight that they carry, is less than what drags casters and other parts
    along and accelerates the robot. Give the wheels in `<gazebo reference="...">` more friction, or casters less, or
    put more of the weight on the wheels.
    """
    return (
        f"the wheels of controller '{controller}' slip: they push with at most {thrust} N, and the robot "
        f"needs {needed} N"
    )
