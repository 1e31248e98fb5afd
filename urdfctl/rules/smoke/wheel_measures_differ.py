"""UC913."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@fault(
    "UC913",
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    authority="diff_drive_controller takes wheel_radius and wheel_separation as they are given",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER,
            "controllers.yaml": (WHEELS % "«base»").replace("wheel_radius: 0.1", "wheel_radius: 0.2"),
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_measures_differ(controller: str, measure: str, expected: str, actual: str) -> str:
    """Wheel radius or separation differs from the robot.

    The robot drives or turns too far or not far enough, and its odometry is wrong by the same factor. The real radius
    is taken from the collision geometry of the wheels. A difference of up to 15 % is accepted as calibration.
    """
    return f"controller '{controller}' expects a {measure} of {expected} m, but the robot has {actual} m"
