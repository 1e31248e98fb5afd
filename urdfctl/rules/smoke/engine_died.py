"""UC920."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC920",
    severity=Severity.ERROR,
    runtime="crashes",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def engine_died(engine: str, why: str) -> str:
    """Physics engine crashed or exceeded its limits.

    The engine crashed, or needed more time or memory than allowed. It is tried once more without the robot's meshes. If
    that fails too, the robot is not simulated; another engine (`--engine mujoco`) may succeed.
    """
    return f"{engine} crashed while simulating the robot: {why}"
