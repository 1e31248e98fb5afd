"""UC941."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC941",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace('effort="20"', 'effort="0.0001"'),
        "controllers.yaml": WHEELS % "«base»",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def does_not_drive_forward(project: Project) -> Iterator[Finding]:
    """A mobile base that is told to drive forward does not.

    It goes too far or not far enough, backwards, or turns on the way: wheels turn the wrong way, do not grip, are too weak,
    or are of another radius than their controller is told.
    """
    return told_by_smoke(project)
