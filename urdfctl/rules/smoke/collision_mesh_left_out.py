"""UC922."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC922",
    severity=Severity.WARNING,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace(
            '<link name="base_link"/>',
            '«<link name="base_link">»<collision><geometry><mesh filename="wheel.obj"/></geometry></collision></link>',
        ),
        "controllers.yaml": GAINS % "mover",
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def collision_mesh_left_out(project: Project) -> Iterator[Finding]:
    """A mesh that a link collides with is not given to the physics engine.

    It is not there, or it is broken: engines end the whole process on some such files. The robot is moved without it; a wheel
    becomes a cylinder of the radius that its controller is told.
    """
    return told_by_smoke(project)
