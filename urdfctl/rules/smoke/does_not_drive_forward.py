"""UC941."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS


@fault(
    "UC941",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": ROVER.replace('effort="20"', 'effort="0.0001"'),
            "controllers.yaml": WHEELS % "«base»",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def does_not_drive_forward(controller: str, expected: str, actual: str) -> str:
    """Mobile base does not drive straight forward.

    It goes too far, not far enough or backwards, or it turns. The wheels turn the wrong way, slip, are too weak, or
    have another radius than their controller uses.
    """
    return f"controller '{controller}' should drive the robot {expected}, but {actual}"
