"""UC933."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC933",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ).replace('<command_interface name="effort"/>', '<command_interface name="velocity"/>'),
            "controllers.yaml": (GAINS % "mover")
            .replace("[effort]", "[velocity]")
            .replace("update_rate: 500", "update_rate: 10")
            .replace("p: 4000.0, i: 100.0, d: 400.0", "p: 30.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_oscillates(controller: str, joint: str, swing: float, unit: str) -> str:
    """Joint oscillates at its target.

    The gains of its control loop are too high, or nothing damps the joint.
    """
    return f"controller '{controller}': joint '{joint}' swings by {swing:.3g} {unit} where it should stand still"
