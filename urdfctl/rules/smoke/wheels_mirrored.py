"""UC959."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import PLAIN_WHEELS, ROVER


@fault(
    "UC959",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="velocity_controllers forward each command to its joint as it is; a joint turns about its axis",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace(
                '<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="continuous">»'
            ).replace('<axis xyz="0 0 1"/><!-- left -->', '<axis xyz="0 0 -1"/>'),
            "controllers.yaml": PLAIN_WHEELS,
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": PLAIN_WHEELS}],
)
def wheels_mirrored(joint: str, other: str) -> str:
    """Wheels under plain velocity controllers turn in opposite directions.

    With the same velocity for all wheels the robot turns on the spot instead of driving forward. That is right if the
    node that commands them changes the sign of one side.
    """
    return f"wheels '{joint}' and '{other}' turn in opposite directions for the same velocity command"
