"""UC964."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test


@rule(
    "UC964",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="controller '{controller}' drives the robot at {speed} m/s at most: {why}",
    authority="a base drives at the speed of its wheels times their radius; its controller clamps its command",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace('velocity="20"', 'velocity="0.01"'),
        "controllers.yaml": WHEELS % "«base»",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def base_too_slow(project: Project) -> Iterator[Finding]:
    """Base that can hardly move.

    The velocity limit of its wheels, or its controller's own limit, allows less than 0.02 m/s. Often the number has
    another unit.
    """
    return found_by_smoke_test(project)
