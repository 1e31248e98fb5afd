"""UC960."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import MECANUM, MECANUM_CONTROLLER


@fault(
    "UC960",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="the controllers command each wheel for its place: diff_drive_controller, mecanum_drive_controller and "
    "omni_wheel_drive_controller, update()",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": MECANUM,
            "controllers.yaml": MECANUM_CONTROLLER.replace("base: {type", "«base»: {type")
            .replace("front_left_wheel_command_joint_name: fl", "front_left_wheel_command_joint_name: fr")
            .replace("front_right_wheel_command_joint_name: fr", "front_right_wheel_command_joint_name: fl"),
        },
    ],
    good=[{"robot.urdf": MECANUM, "controllers.yaml": MECANUM_CONTROLLER}],
)
def wheel_in_the_wrong_place(controller: str, joint: str, role: str, actual: str) -> str:
    """Wheel is not where its controller expects it.

    The controller computes each wheel's speed for a place on the robot. With two wheels exchanged the robot turns when
    it should drive sideways, or slips.
    """
    return f"controller '{controller}' uses '{joint}' as {role}, but it is {actual}"
