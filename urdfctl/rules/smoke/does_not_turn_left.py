"""UC942."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, told_by_smoke


@rule(
    "UC942",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
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
def does_not_turn_left(project: Project) -> Iterator[Finding]:
    """A mobile base that is told to turn left does not.

    It turns right, or by far too much or too little: left and right are exchanged, a steering axis stands upside down, or the
    wheels are farther apart than their controller is told.
    """
    return told_by_smoke(project)
