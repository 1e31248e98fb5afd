"""UC975."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, geared


@fault(
    "UC975",
    severity=Severity.WARNING,
    runtime="refuses",
    because="only hardware that loads transmissions does",
    authority="transmission_interface/simple_transmission.hpp; no transmission is read by gz_ros2_control's gz_system.cpp, "
    "gazebo_ros2_control's gazebo_system.cpp, mock_components' generic_system.cpp and gazebo_ros_control's "
    "default_robot_hw_sim.cpp",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": geared(GRIPPER, "finger", "0")
            .replace("mock_components/GenericSystem", "my_driver/Gripper")
            .replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[
        {
            "robot.urdf": geared(GRIPPER, "finger", "-50").replace(
                "mock_components/GenericSystem", "my_driver/Gripper"
            ),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
)
def reduction_of_zero(joint: str) -> str:
    """Reduction of 0.

    Hardware that loads the transmission stops with 'Transmission reduction ratio cannot be zero.', and no controller
    gets an interface of it.
    """
    return (
        f"the reduction of joint '{joint}' is 0: hardware that uses its transmission does not start. Write "
        "the number of turns of the motor for one of the joint, or 1"
    )
