"""UC973."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, geared


@fault(
    "UC973",
    severity=Severity.INFO,
    runtime="ignores",
    because="the joint moves as its axis says, with any reduction",
    authority="transmission_interface/simple_transmission.hpp; no transmission is read by gz_ros2_control's gz_system.cpp, "
    "gazebo_ros2_control's gazebo_system.cpp, mock_components' generic_system.cpp and gazebo_ros_control's "
    "default_robot_hw_sim.cpp",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": geared(GRIPPER, "finger", "-1").replace(
                '<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'
            ),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": geared(GRIPPER, "finger", "1"), "controllers.yaml": GRIPPER_CONTROLLER}],
)
def negative_reduction_ignored(reduction: str, joint: str, hardware: str) -> str:
    """Negative reduction that the hardware ignores.

    A negative reduction says that motor and joint turn in opposite directions. Simulated hardware ignores it, and moves
    the joint as its axis says. On hardware that uses transmissions the joint moves as its axis says too: only the motor
    turns the other way.
    """
    return (
        f"the reduction of {reduction} does not reverse joint '{joint}': {hardware} ignores it. If the joint "
        "should turn the other way, change its axis"
    )
