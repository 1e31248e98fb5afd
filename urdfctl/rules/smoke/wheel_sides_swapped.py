"""UC911."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left


@rule(
    "UC911",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    explains=(does_not_drive_forward, does_not_turn_left),
    message="controller '{controller}' has left and right wheels swapped: its left wheel '{left}' is on the "
    "right side, and its right wheel '{right}' on the left",
    authority="diff_drive_controller: the left wheel's velocity is (linear - angular * separation / 2) / radius",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER,
        "controllers.yaml": (WHEELS % "«base»")
        .replace("left_wheel]", "x]")
        .replace("right_wheel]", "left_wheel]")
        .replace("x]", "right_wheel]"),
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def wheel_sides_swapped(project: Project) -> Iterator[Finding]:
    """Left and right wheels are swapped.

    The robot turns right when it is commanded to turn left, while driving straight looks correct. The check uses the
    positions of the wheels in the base frame at spawn.
    """
    return found_by_smoke_test(project)
