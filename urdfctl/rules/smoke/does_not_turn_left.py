"""UC942."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, TRICYCLE, TRICYCLE_CONTROLLER, WHEELS


@fault(
    "UC942",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": TRICYCLE.replace('<axis xyz="0 0 1"/><!-- steer -->', '<axis xyz="0 0 -1"/>'),
            "controllers.yaml": TRICYCLE_CONTROLLER.replace(" base: ", " «base»: "),
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def does_not_turn_left(controller: str, expected: float, actual: float) -> str:
    """Mobile base does not turn left as commanded.

    It turns right, or far too much or too little. Left and right are swapped, a steering axis points down, or the
    wheels are farther apart than their controller expects.
    """
    return f"controller '{controller}' should turn the robot by {expected:+.2g} rad, but it turns by {actual:+.2g} rad"
