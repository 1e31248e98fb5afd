"""UC934."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC934",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joints_oscillate_together(project: Project) -> Iterator[Finding]:
    """Joints that stand still one at a time swing when all loops run at once.

    They shake each other: the movement of one is a push to the next.
    """
    return told_by_smoke(project)
