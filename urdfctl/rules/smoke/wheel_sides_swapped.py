"""UC911."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC911",
    severity=Severity.ERROR,
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
    """A drive's left wheels are on the right side of the robot.

    Told to turn left the robot turns right; driving straight looks well. It is told from where the wheels are in the frame
    of the base, at spawn.
    """
    return told_by_smoke(project)
