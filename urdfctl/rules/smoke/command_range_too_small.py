"""UC954."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, found_by_smoke_test


@rule(
    "UC954",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="<ros2_control> allows the {interface} command of joint '{joint}' only from {low:g} to {high:g}; the joint's own "
    "range is {least:.3g} to {most:.3g}",
    authority="hardware_interface: <param name='min'> and <param name='max'> of a command interface limit its commands",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": GRIPPER.replace(
            '<command_interface name="position"/>',
            '<command_interface name="position"><param name="min">0</param><param name="max">0.0001</param>'
            "</command_interface>",
        ).replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
        "controllers.yaml": GRIPPER_CONTROLLER,
    },
    good={"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER},
)
def command_range_too_small(project: Project) -> Iterator[Finding]:
    """Range of a command interface leaves hardly any motion.

    The limits `min` and `max` of the command interface overlap with less than a hundredth of the joint's range. Often
    they are in another unit, or were meant for another joint.
    """
    return found_by_smoke_test(project)
