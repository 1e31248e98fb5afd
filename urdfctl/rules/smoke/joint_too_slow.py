"""UC994."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC994",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gz_ros2_control and gazebo_ros_control clamp velocities to the joint's limit; a trajectory controller does not read it",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('velocity="1"', 'velocity="0.005"').replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_too_slow(joint: str, controller: str, limit: str, unit: str, seconds: str) -> str:
    """Velocity limit far too low for the joint's range.

    The joint lags behind each command, and a controller with a tolerance aborts the motion. Often the limit has another
    unit, or the ratio of the gear was applied twice. More than two minutes across the range are reported.
    """
    return (
        f"joint '{joint}' of controller '{controller}' has a velocity limit of {limit} {unit}/s, with which it takes "
        f"{seconds} s across its range"
    )
