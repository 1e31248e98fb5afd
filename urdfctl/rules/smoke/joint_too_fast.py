"""UC937."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC937",
    severity=Severity.WARNING,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_too_fast(project: Project) -> Iterator[Finding]:
    """A joint moves faster than its velocity limit.

    Engines do not hold the limit under an effort; a real drive stops then, or cuts the motion short.
    """
    return told_by_smoke(project)
