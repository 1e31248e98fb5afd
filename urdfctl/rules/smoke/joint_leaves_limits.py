"""UC936."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC936",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_leaves_limits(project: Project) -> Iterator[Finding]:
    """A joint is driven past its limits.

    Its loop overshoots where there is no room for it.
    """
    return told_by_smoke(project)
