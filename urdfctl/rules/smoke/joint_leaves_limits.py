"""UC936."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC936",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_leaves_limits(
    controller: str, joint: str, least: float, most: float, unit: str, lower: float, upper: float
) -> str:
    """Joint exceeds its position limits.

    Its control loop overshoots, and the limits leave no room for that.
    """
    return (
        f"controller '{controller}': joint '{joint}' moves from {least:.3g} to {most:.3g} {unit}, but its "
        f"limits are {lower:g} to {upper:g} {unit}"
    )
