"""UC910."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import LIFT, told_by_smoke


@rule(
    "UC910",
    severity=Severity.ERROR,
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
    """A link has a mass or an inertia that no body can have.

    Not a number, or less than nothing: the first step of a simulator spreads it over the whole robot.
    """
    return told_by_smoke(project)
