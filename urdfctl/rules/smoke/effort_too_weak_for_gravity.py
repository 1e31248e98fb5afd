"""UC915."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast


@fault(
    "UC915",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="gazebo_ros_control and gz_ros2_control clamp efforts to the joint's limit",
    explains=(joint_does_not_follow, joint_leaves_limits, joint_oscillates, joint_too_fast),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('effort="500"', 'effort="20"').replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def effort_too_weak_for_gravity(joint: str, needed: float, unit: str, limit: float) -> str:
    """Effort limit too low to hold the robot.

    The joint sinks at spawn, whatever its controller commands. The load is computed from the masses and their
    positions. Joints with an effort limit of 0 are not checked, because many descriptions use 0 for an unknown limit.
    """
    return (
        f"joint '{joint}' needs {needed:.3g} {unit} to hold the robot at spawn, but its effort limit is "
        f"{limit:g} {unit}"
    )
