"""UC962."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS


@fault(
    "UC962",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="a mass m reaches the speed v in t seconds with the force m v / t; the thrust of a wheel is effort / radius",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('effort="20"', 'effort="0.001"'),
            "controllers.yaml": WHEELS % "«base»",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheels_too_weak(controller: str, thrust: str, mass: str, seconds: str, speed: str) -> str:
    """Wheels too weak to accelerate the robot.

    The effort limits of the driven wheels allow so little thrust that the robot takes longer than two seconds to reach
    the speed of the test.
    """
    return (
        f"the wheels of controller '{controller}' are too weak: their effort limits allow {thrust} N, with "
        f"which {mass} kg take {seconds} s to reach {speed} m/s"
    )
