"""UC913."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@rule(
    "UC913",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    message="controller '{controller}' expects a {measure} of {expected} m, but the robot has {actual} m",
    authority="diff_drive_controller takes wheel_radius and wheel_separation as they are given",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER,
        "controllers.yaml": (WHEELS % "«base»").replace("wheel_radius: 0.1", "wheel_radius: 0.2"),
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def wheel_measures_differ(project: Project) -> Iterator[Finding]:
    """Wheel radius or separation differs from the robot.

    The robot drives or turns too far or not far enough, and its odometry is wrong by the same factor. The real radius
    is taken from the collision geometry of the wheels. A difference of up to 15 % is accepted as calibration.
    """
    return found_by_smoke_test(project)
