"""UC941."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test


@rule(
    "UC941",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="controller '{controller}' should drive the robot {expected}, but {actual}",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace('effort="20"', 'effort="0.0001"'),
        "controllers.yaml": WHEELS % "«base»",
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def does_not_drive_forward(project: Project) -> Iterator[Finding]:
    """Mobile base does not drive straight forward.

    It goes too far, not far enough or backwards, or it turns. The wheels turn the wrong way, slip, are too weak, or
    have another radius than their controller uses.
    """
    return found_by_smoke_test(project)
