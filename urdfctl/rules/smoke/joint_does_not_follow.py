"""UC932."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC932",
    severity=Severity.ERROR,
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
    """A joint does not come to where its controller tells it to go.

    Its effort limit, or its gains, are too small for what hangs on it; or something holds it.
    """
    return told_by_smoke(project)
