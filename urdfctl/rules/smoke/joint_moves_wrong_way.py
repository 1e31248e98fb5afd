"""UC935."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC935",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»')
            .replace('name="effort"', 'name="velocity"')
            .replace('effort="500"', 'effort="60"')
            .replace('mass value="5"', 'mass value="50"'),
            "controllers.yaml": (GAINS % "mover")
            .replace(
                "joint_trajectory_controller/JointTrajectoryController",
                "velocity_controllers/JointGroupVelocityController",
            )
            .split("        command_interfaces")[0],
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_moves_wrong_way(controller: str, joint: str, command: str, actual: float, unit: str) -> str:
    """Joint does not move as commanded.

    It stands still, runs away, or moves in the wrong direction under a velocity or effort command. A gain or the
    command has the wrong sign, or something blocks the joint.
    """
    return f"controller '{controller}': joint '{joint}' {command}, but moves by {actual:+.3g} {unit}"
