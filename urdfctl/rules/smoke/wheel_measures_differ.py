"""UC913."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC913",
    severity=Severity.ERROR,
    authority="diff_drive_controller takes wheel_radius and wheel_separation as they are given",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER,
        "controllers.yaml": (WHEELS % "«base»").replace("wheel_radius: 0.1", "wheel_radius: 0.2"),
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def wheel_measures_differ(project: Project) -> Iterator[Finding]:
    """A drive is told wheels of another radius, or of another distance, than the robot has.

    The robot drives or turns by as much too far or not far enough, and its odometry is wrong by as much. What collides with
    the ground tells the radius; wheels that are a little apart from what is told (15 %) are taken as tuned.
    """
    return told_by_smoke(project)
