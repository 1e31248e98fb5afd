"""UC934."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC934",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joints_oscillate_together(controller: str, joint: str, swing: float, unit: str) -> str:
    """Joints oscillate when all control loops run together.

    Each joint stands still when it is moved alone. Together they disturb each other: a movement of one pushes the next.
    """
    return (
        f"controller '{controller}': joint '{joint}' swings by {swing:.3g} {unit} when all control loops run together"
    )
