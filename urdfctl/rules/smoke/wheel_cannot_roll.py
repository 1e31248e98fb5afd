"""UC955."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test


@rule(
    "UC955",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="wheel '{joint}' of controller '{controller}' is {type} and turns only from {low:.3g} to {high:.3g}; its type should "
    "be continuous",
    authority="URDF: a revolute joint stops at its limits",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace(
            '<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="revolute">»'
        ).replace("<!-- left --><limit", '<limit lower="-0.5" upper="0.5"'),
        "controllers.yaml": WHEELS % "base",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def wheel_cannot_roll(project: Project) -> Iterator[Finding]:
    """Driven wheel with position limits.

    The wheel stops after less than two turns, and the robot with it.
    """
    return found_by_smoke_test(project)
