"""UC911."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@fault(
    "UC911",
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    authority="diff_drive_controller: the left wheel's velocity is (linear - angular * separation / 2) / radius",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER,
            "controllers.yaml": (WHEELS % "«base»")
            .replace("left_wheel]", "x]")
            .replace("right_wheel]", "left_wheel]")
            .replace("x]", "right_wheel]"),
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_sides_swapped(controller: str, left: str, right: str) -> str:
    """Left and right wheels are swapped.

    The robot turns right when it is commanded to turn left, while driving straight looks correct. The check uses the
    positions of the wheels in the base frame at spawn.
    """
    return (
        f"controller '{controller}' has left and right wheels swapped: its left wheel '{left}' is on the "
        f"right side, and its right wheel '{right}' on the left"
    )
