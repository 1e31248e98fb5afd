"""UC986."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS
from urdfctl.rules.smoke.wheel_off_the_ground import standing_on


@fault(
    "UC986",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured: the pose of least height of the centre of mass; the controller assumes that the base stands upright",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace(
                '<joint name="front_mount" type="fixed">', '«<joint name="front_mount" type="fixed">»'
            )
            .replace('xyz="0.15 0 -0.05"', 'xyz="0.15 0 0"')
            .replace('<mass value="5"/>', '<origin xyz="0.08 0 0"/><mass value="5"/>'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def base_leans(degrees: float, on: Sequence[str], high: Sequence[str] = (), height: str = "") -> str:
    """Base that leans at rest.

    A caster is mounted too high or too low, or it is missing: sensors look up or down, and wheels lose their grip.
    """
    names = " and ".join(f"'{name}'" for name in high[:2])
    higher = (
        f"; {names} {'are' if len(high) > 1 else 'is'} {height} m higher than the lowest part of the robot"
        if high
        else ""
    )
    return f"the robot leans by {degrees:.0f} degrees at rest{standing_on(on)}{higher}"
