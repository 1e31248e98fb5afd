"""UC955."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@fault(
    "UC955",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="URDF: a revolute joint stops at its limits",
    explains=(
        does_not_drive_forward,
        does_not_turn_left,
    ),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace(
                '<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="revolute">»'
            ).replace("<!-- left --><limit", '<limit lower="-0.5" upper="0.5"'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_cannot_roll(joint: str, controller: str, kind: str, low: float, high: float) -> str:
    """Driven wheel with position limits.

    The wheel stops after less than two turns, and the robot with it.
    """
    return (
        f"wheel '{joint}' of controller '{controller}' is {kind} and turns only from {low:.3g} to {high:.3g}; "
        "its type should be continuous"
    )
