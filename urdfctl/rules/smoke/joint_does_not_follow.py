"""UC932."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC932",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="controller '{controller}': joint '{joint}' should move by {expected:+.3g} {unit}, but moves by "
    "{actual:+.3g} {unit}",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace(
            '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
        ).replace('effort="500"', 'effort="30"'),
        "controllers.yaml": GAINS % "mover",
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_does_not_follow(project: Project) -> Iterator[Finding]:
    """Joint does not reach its target.

    Its effort limit or its gains are too low for the load on it, or something blocks it.
    """
    return found_by_smoke_test(project)
