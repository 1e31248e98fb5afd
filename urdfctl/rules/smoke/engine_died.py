"""UC920."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC920",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def engine_died(project: Project) -> Iterator[Finding]:
    """The physics engine dies while it moves a robot.

    It ended itself, or took more time or memory than a robot needs. It is tried a second time without meshes. The robot is
    not judged further; another engine (`--engine mujoco`) may take it.
    """
    return told_by_smoke(project)
