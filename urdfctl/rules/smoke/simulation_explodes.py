"""UC930."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC930",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def simulation_explodes(project: Project) -> Iterator[Finding]:
    """The state of the robot is no number any more, or far too large.

    Gains that are far too high do it, and inertias that are far too small for the forces on them.
    """
    return told_by_smoke(project)
