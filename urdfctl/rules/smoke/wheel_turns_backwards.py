"""UC912."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@rule(
    "UC912",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    message="wheel '{joint}' turns {how} when controller '{controller}' drives forward",
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
    """Driven wheel turns backwards or about the wrong axis.

    A positive velocity must roll the robot forward: the wheel's axis must point to the left in the base frame.
    Otherwise the robot drives backwards, or turns on the spot, when it is commanded to drive forward.
    """
    return found_by_smoke_test(project)
