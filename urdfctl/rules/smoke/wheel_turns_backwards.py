"""UC912."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC912",
    severity=Severity.ERROR,
    authority="REP 103: x forward, y left; a wheel that rolls forward turns about y",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace(
            '<joint name="left_wheel" type="continuous">', '«<joint name="left_wheel" type="continuous">»'
        ).replace('xyz="0 0 1"/><!-- left -->', 'xyz="0 0 -1"/>'),
        "controllers.yaml": WHEELS % "base",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def wheel_turns_backwards(project: Project) -> Iterator[Finding]:
    """A driven wheel turns backwards, or about an axis on which it cannot roll.

    A wheel whose velocity is positive must roll the robot forward: seen from the base its axis points to the left. Told to
    drive forward the robot goes back, or turns on the spot.
    """
    return told_by_smoke(project)
