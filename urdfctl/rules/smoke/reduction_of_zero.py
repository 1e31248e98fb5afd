"""UC975."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, found_by_smoke_test, geared


@rule(
    "UC975",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="refuses",
    because="only hardware that loads transmissions does",
    message="the reduction of joint '{joint}' is 0: hardware that uses its transmission does not start. "
    "Write the number of turns of the motor for one of the joint, or 1",
    authority="transmission_interface/simple_transmission.hpp; no transmission is read by gz_ros2_control's gz_system.cpp, "
    "gazebo_ros2_control's gazebo_system.cpp, mock_components' generic_system.cpp and gazebo_ros_control's "
    "default_robot_hw_sim.cpp",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": geared(GRIPPER, "finger", "0")
        .replace("mock_components/GenericSystem", "my_driver/Gripper")
        .replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
        "controllers.yaml": GRIPPER_CONTROLLER,
    },
    good={
        "robot.urdf": geared(GRIPPER, "finger", "-50").replace("mock_components/GenericSystem", "my_driver/Gripper"),
        "controllers.yaml": GRIPPER_CONTROLLER,
    },
)
def reduction_of_zero(project: Project) -> Iterator[Finding]:
    """Reduction of 0.

    Hardware that loads the transmission stops with 'Transmission reduction ratio cannot be zero.', and no controller
    gets an interface of it.
    """
    return found_by_smoke_test(project)
