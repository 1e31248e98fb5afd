"""UC938."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC938",
    severity=Severity.WARNING,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def mimic_not_kept(project: Project) -> Iterator[Finding]:
    """A joint does not keep to the one that it mimics.

    Something holds it, or a controller drives it itself.
    """
    return told_by_smoke(project)
