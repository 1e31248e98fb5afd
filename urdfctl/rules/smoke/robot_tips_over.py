"""UC931."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC931",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace('<robot name="rover">', '«<robot name="rover">»')
        .replace('xyz="0.15 0 -0.05"', 'xyz="0.15 0 0.2"')
        .replace('xyz="-0.15 0 -0.05"', 'xyz="-0.15 0 0.2"')
        .replace('xyz="0 0.15 0"', 'xyz="0.3 0.15 0"')
        .replace('xyz="0 -0.15 0"', 'xyz="0.3 -0.15 0"')
        .replace('xyz="0 0 0.05"', 'xyz="0 0 0.3"'),
        "controllers.yaml": WHEELS % "base",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def robot_tips_over(project: Project) -> Iterator[Finding]:
    """A mobile base tips over as soon as it stands.

    It stands on its wheels and on what else touches the ground: without a caster two wheels do not carry it.
    """
    return told_by_smoke(project)
