"""UC938."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC938",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="joint '{joint}' is {distance:.2g} {unit} away from where it should mimic joint '{leader}'",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def mimic_not_kept(project: Project) -> Iterator[Finding]:
    """Mimic joint does not follow its leader.

    Something blocks the joint, or a controller drives it directly.
    """
    return found_by_smoke_test(project)
