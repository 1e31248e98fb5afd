"""UC964."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS


@fault(
    "UC964",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="a base drives at the speed of its wheels times their radius; its controller clamps its command",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('velocity="20"', 'velocity="0.01"'),
            "controllers.yaml": WHEELS % "«base»",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def base_too_slow(controller: str, speed: str, why: str) -> str:
    """Base that can hardly move.

    The velocity limit of its wheels, or its controller's own limit, allows less than 0.02 m/s. Often the number has
    another unit.
    """
    return f"controller '{controller}' drives the robot at {speed} m/s at most: {why}"
