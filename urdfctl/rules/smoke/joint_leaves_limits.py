"""UC936."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC936",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="controller '{controller}': joint '{joint}' moves from {least:.3g} to {most:.3g} {unit}, but its "
    "limits are {lower:g} to {upper:g} {unit}",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_leaves_limits(project: Project) -> Iterator[Finding]:
    """Joint exceeds its position limits.

    Its control loop overshoots, and the limits leave no room for that.
    """
    return found_by_smoke_test(project)
