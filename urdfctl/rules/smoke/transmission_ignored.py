"""UC972."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, geared


@fault(
    "UC972",
    severity=Severity.INFO,
    runtime="ignores",
    because="the joint moves as commanded",
    authority="transmission_interface/simple_transmission.hpp; no transmission is read by gz_ros2_control's gz_system.cpp, "
    "gazebo_ros2_control's gazebo_system.cpp, mock_components' generic_system.cpp and gazebo_ros_control's "
    "default_robot_hw_sim.cpp",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": geared(GRIPPER, "finger", "50").replace('<robot name="gripper">', '«<robot name="gripper">»'),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": geared(GRIPPER, "finger", "1"), "controllers.yaml": GRIPPER_CONTROLLER}],
)
def transmission_ignored(hardware: str, what: str, joint: str, more: str) -> str:
    """Transmission that the hardware ignores.

    Simulated hardware commands the joints, and has no motors: a reduction or an offset has no effect there. Real hardware
    that loads transmissions uses them. It is said once for a robot.
    """
    return f"{hardware} ignores {what} of joint '{joint}'{more}: it moves the joint itself"
