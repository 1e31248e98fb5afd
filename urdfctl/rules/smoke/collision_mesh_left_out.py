"""UC922."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC922",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="the collision geometry of link '{link}' is ignored{more}: {why}",
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
    """Collision geometry cannot be simulated.

    The mesh is missing or broken. Some broken meshes crash physics engines, so the robot is simulated without it. A
    wheel gets a cylinder with the radius that its controller uses.
    """
    return found_by_smoke_test(project)
