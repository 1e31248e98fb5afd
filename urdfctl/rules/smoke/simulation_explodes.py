"""UC930."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC930",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="the simulation explodes{when}: the robot's positions are not finite, or far too large",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def simulation_explodes(project: Project) -> Iterator[Finding]:
    """Simulation explodes.

    A position of the robot is not a finite number, or is far too large. The usual causes are gains that are far too
    high and inertias that are far too small for the forces on them.
    """
    return found_by_smoke_test(project)
