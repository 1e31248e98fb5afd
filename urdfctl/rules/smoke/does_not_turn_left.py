"""UC942."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, TRICYCLE, TRICYCLE_CONTROLLER, WHEELS, found_by_smoke_test


@rule(
    "UC942",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="controller '{controller}' should turn the robot by {expected:+.2g} rad, but it turns by {actual:+.2g} rad",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": TRICYCLE.replace('<axis xyz="0 0 1"/><!-- steer -->', '<axis xyz="0 0 -1"/>'),
        "controllers.yaml": TRICYCLE_CONTROLLER.replace(" base: ", " «base»: "),
    },
    good={"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"},
)
def does_not_turn_left(project: Project) -> Iterator[Finding]:
    """Mobile base does not turn left as commanded.

    It turns right, or far too much or too little. Left and right are swapped, a steering axis points down, or the
    wheels are farther apart than their controller expects.
    """
    return found_by_smoke_test(project)
