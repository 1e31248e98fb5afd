"""UC951."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC951",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="joint '{joint}' has a {what}: with its effort limit of {limit:g} {unit} it moves {how}",
    authority="URDF: the friction of a joint is an effort, and its damping an effort for each unit of speed",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('velocity="1"/>', 'velocity="1"/><dynamics damping="0" friction="600"/>').replace(
            '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
        ),
        "controllers.yaml": GAINS % "mover",
    },
    good={
        "robot.urdf": LIFT.replace('velocity="1"/>', 'velocity="1"/><dynamics damping="10" friction="5"/>'),
        "controllers.yaml": GAINS % "mover",
    },
)
def joint_resists_its_motor(project: Project) -> Iterator[Finding]:
    """Joint friction or damping uses up the effort limit.

    The motor of the joint cannot overcome its friction, or its damping holds it far below the speed of the test motion.
    Often the number has another unit, or was tuned for a simulator that ignores the effort limit.
    """
    return found_by_smoke_test(project)
