"""UC921."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC921",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def engine_refuses_robot(engine: str, why: str) -> str:
    """Physics engine rejects the robot.

    The message quotes the engine. Another engine may accept the robot. The smoke test itself rejects a robot that all
    engines would: one with a joint that turns about the axis 0 0 0.
    """
    return f"{engine} rejects the robot: {why}"
