"""UC952."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_moves_wrong_way import joint_moves_wrong_way


@fault(
    "UC952",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="a mass m reaches the distance s in t seconds with at least the force 2 m s / t²; "
    "gz_ros2_control clamps efforts to the joint's limit",
    explains=(joint_does_not_follow, joint_moves_wrong_way),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": GRIPPER.replace('effort="20"', 'effort="0.00001"').replace(
                '<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'
            ),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def effort_too_weak_to_move(joint: str, needed: float, unit: str, limit: float) -> str:
    """Effort limit too low to accelerate the joint.

    Even at full effort the joint does not cover the distance of the test motion in time. An effort limit of 0 counts
    only for a joint that is commanded by effort: many descriptions use 0 for an unknown limit.
    """
    return (
        f"joint '{joint}' needs at least {needed:.2g} {unit} for the test motion, but its effort limit is "
        f"{limit:g} {unit}"
    )
