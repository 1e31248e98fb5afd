"""UC930."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC930",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def simulation_explodes(when: str) -> str:
    """Simulation explodes.

    A position of the robot is not a finite number, or is far too large. The usual causes are gains that are far too
    high and inertias that are far too small for the forces on them.
    """
    return f"the simulation explodes{when}: the robot's positions are not finite, or far too large"
