"""UC920."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC920",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="crashes",
    message="{engine} crashed while simulating the robot: {why}",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def engine_died(project: Project) -> Iterator[Finding]:
    """Physics engine crashed or exceeded its limits.

    The engine crashed, or needed more time or memory than allowed. It is tried once more without the robot's meshes. If
    that fails too, the robot is not simulated; another engine (`--engine mujoco`) may succeed.
    """
    return found_by_smoke_test(project)
