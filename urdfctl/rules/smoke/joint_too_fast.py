"""UC937."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC937",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="controller '{controller}': joint '{joint}' moves at {fastest:.3g} {unit}/s, but its velocity limit "
    "is {limit:g} {unit}/s",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_too_fast(project: Project) -> Iterator[Finding]:
    """Joint exceeds its velocity limit.

    Physics engines do not enforce the limit under an effort command. A real drive stops, or cuts the motion short.
    """
    return found_by_smoke_test(project)
