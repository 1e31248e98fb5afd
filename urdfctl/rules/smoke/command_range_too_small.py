"""UC954."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER


@fault(
    "UC954",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="hardware_interface: <param name='min'> and <param name='max'> of a command interface limit its commands",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": GRIPPER.replace(
                '<command_interface name="position"/>',
                '<command_interface name="position"><param name="min">0</param><param name="max">0.0001</param>'
                "</command_interface>",
            ).replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def command_range_too_small(interface: str, joint: str, low: float, high: float, least: float, most: float) -> str:
    """Range of a command interface leaves hardly any motion.

    The limits `min` and `max` of the command interface overlap with less than a hundredth of the joint's range. Often
    they are in another unit, or were meant for another joint.
    """
    return (
        f"<ros2_control> allows the {interface} command of joint '{joint}' only from {low:g} to {high:g}; the "
        f"joint's own range is {least:.3g} to {most:.3g}"
    )
