"""UC914."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC914",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="gazebo_ros_control and gz_ros2_control clamp velocities to the joint's limit",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('velocity="1"', 'velocity="0"').replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_held_still(joint: str, controller: str) -> str:
    """Controlled joint with a velocity limit of 0.

    Simulators and drivers obey the limit: the controller is active, but the joint does not move.
    """
    return f"joint '{joint}' has a velocity limit of 0, so controller '{controller}' cannot move it. Set the real limit"
