"""UC931."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS


@fault(
    "UC931",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('<robot name="rover">', '«<robot name="rover">»')
            .replace('xyz="0.15 0 -0.05"', 'xyz="0.15 0 0.2"')
            .replace('xyz="-0.15 0 -0.05"', 'xyz="-0.15 0 0.2"')
            .replace('xyz="0 0.15 0"', 'xyz="0.3 0.15 0"')
            .replace('xyz="0 -0.15 0"', 'xyz="0.3 -0.15 0"')
            .replace('xyz="0 0 0.05"', 'xyz="0 0 0.3"'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def robot_tips_over(when: str, roll: float, pitch: float) -> str:
    """Mobile base tips over.

    It falls over as soon as it stands on the ground. Only its wheels and other parts that touch the ground support it:
    two wheels without a caster do not.
    """
    roll, pitch = (round(angle, 3) + 0.0 for angle in (roll, pitch))  # no power of ten, and no -0
    return f"the robot tips over{when}: roll {roll:.2g} rad, pitch {pitch:.2g} rad"
