"""UC940."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


def standing_on(links: Sequence[str]) -> str:
    """Return the words that name the links on which a robot stands; none if there are none."""
    names = [f"'{name}'" for name in links]
    more = f" and {len(names) - 3} more" if len(names) > 3 else ""  # noqa: PLR2004
    return f": the robot stands on {', '.join(names[:3])}{more}" if names else ""


@fault(
    "UC940",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    explains=(
        does_not_drive_forward,
        does_not_turn_left,
    ),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('xyz="0 0.15 0"', 'xyz="0 0.15 0.03"')
            .replace('<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="continuous">»')
            .replace('xyz="0.15 0 -0.05"', 'xyz="0.15 0.1 -0.05"')
            .replace('xyz="-0.15 0 -0.05"', 'xyz="-0.15 0.1 -0.05"'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_off_the_ground(joint: str, controller: str, on: Sequence[str]) -> str:
    """Driven wheel does not touch the ground.

    It is mounted too high, it has no collision geometry, or other parts of the robot carry the weight.
    """
    return f"wheel '{joint}' of controller '{controller}' does not touch the ground{standing_on(on)}"
