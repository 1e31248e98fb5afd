"""UC912."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@fault(
    "UC912",
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    authority="REP 103: x forward, y left; a wheel that rolls forward turns about y",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace(
                '<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="continuous">»'
            ).replace('xyz="0 0 1"/><!-- left -->', 'xyz="0 0 -1"/>'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_turns_backwards(joint: str, how: str, controller: str) -> str:
    """Driven wheel turns backwards or about the wrong axis.

    A positive velocity must roll the robot forward: the wheel's axis must point to the left in the base frame.
    Otherwise the robot drives backwards, or turns on the spot, when it is commanded to drive forward.
    """
    return f"wheel '{joint}' turns {how} when controller '{controller}' drives forward"
