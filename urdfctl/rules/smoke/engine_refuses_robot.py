"""UC921."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC921",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="refuses",
    message="{engine} rejects the robot: {why}",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def engine_refuses_robot(project: Project) -> Iterator[Finding]:
    """Physics engine rejects the robot.

    The message quotes the engine. Another engine may accept the robot.
    """
    return found_by_smoke_test(project)
