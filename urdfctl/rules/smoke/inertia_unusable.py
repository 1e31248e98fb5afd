"""UC910."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import LIFT, found_by_smoke_test


@rule(
    "UC910",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="link '{link}' has a mass or inertia that is {problem}",
    authority="measured: an engine that is given such a body puts nan into every state of the robot",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('ixx="0.05"', 'ixx="-0.05"').replace(
            '<link name="carriage">', '«<link name="carriage">»'
        )
    },
    good={"robot.urdf": LIFT},
)
def inertia_unusable(project: Project) -> Iterator[Finding]:
    """Mass or inertia is negative or not a finite number.

    No body can have such a mass or inertia. In the first step of a simulation the invalid value spreads over the whole
    robot.
    """
    return found_by_smoke_test(project)
