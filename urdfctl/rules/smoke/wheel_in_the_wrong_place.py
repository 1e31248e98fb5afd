"""UC960."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import MECANUM, MECANUM_CONTROLLER, found_by_smoke_test


@rule(
    "UC960",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="controller '{controller}' uses '{joint}' as {role}, but it is {actual}",
    authority="the controllers command each wheel for its place: diff_drive_controller, mecanum_drive_controller and "
    "omni_wheel_drive_controller, update()",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": MECANUM,
        "controllers.yaml": MECANUM_CONTROLLER.replace("base: {type", "«base»: {type")
        .replace("front_left_wheel_command_joint_name: fl", "front_left_wheel_command_joint_name: fr")
        .replace("front_right_wheel_command_joint_name: fr", "front_right_wheel_command_joint_name: fl"),
    },
    good={"robot.urdf": MECANUM, "controllers.yaml": MECANUM_CONTROLLER},
)
def wheel_in_the_wrong_place(project: Project) -> Iterator[Finding]:
    """Wheel is not where its controller expects it.

    The controller computes each wheel's speed for a place on the robot. With two wheels exchanged the robot turns when
    it should drive sideways, or slips.
    """
    return found_by_smoke_test(project)
