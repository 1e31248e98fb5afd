"""UC938."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC938",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def mimic_not_kept(joint: str, distance: float, unit: str, leader: str) -> str:
    """Mimic joint does not follow its leader.

    Something blocks the joint, or a controller drives it directly.
    """
    return f"joint '{joint}' is {distance:.2g} {unit} away from where it should mimic joint '{leader}'"
