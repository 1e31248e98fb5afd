"""UC921."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC921",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def engine_refuses_robot(project: Project) -> Iterator[Finding]:
    """The physics engine does not take a robot.

    It says why, in its own words; another engine may take it.
    """
    return told_by_smoke(project)
