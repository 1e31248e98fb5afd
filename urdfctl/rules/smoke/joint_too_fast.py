"""UC937."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC937",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_too_fast(controller: str, joint: str, fastest: float, unit: str, limit: float) -> str:
    """Joint exceeds its velocity limit.

    Physics engines do not enforce the limit under an effort command. A real drive stops, or cuts the motion short.
    """
    return (
        f"controller '{controller}': joint '{joint}' moves at {fastest:.3g} {unit}/s, but its velocity limit "
        f"is {limit:g} {unit}/s"
    )
