"""UC932."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC932",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»')
            .replace('<axis xyz="0 0 1"/>', '<axis xyz="1 0 0"/>')
            .replace('velocity="1"/>', 'velocity="1"/><dynamics friction="40"/>'),
            "controllers.yaml": (GAINS % "mover").replace("p: 4000.0", "p: 200.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_does_not_follow(controller: str, joint: str, expected: float, unit: str, actual: float) -> str:
    """Joint does not reach its target.

    Its effort limit or its gains are too low for the load on it, or something blocks it.
    """
    return (
        f"controller '{controller}': joint '{joint}' should move by {expected:+.3g} {unit}, but moves by "
        f"{actual:+.3g} {unit}"
    )
