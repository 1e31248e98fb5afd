"""UC974."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS, geared


@fault(
    "UC974",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="transmission_interface/simple_transmission.hpp; no transmission is read by gz_ros2_control's gz_system.cpp, "
    "gazebo_ros2_control's gazebo_system.cpp, mock_components' generic_system.cpp and gazebo_ros_control's "
    "default_robot_hw_sim.cpp",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": geared(geared(ROVER, "left_wheel", "30"), "right_wheel", "60")
            .replace("mock_components/GenericSystem", "my_driver/Base")
            .replace('<joint name="right_wheel" type="continuous">', '«<joint name="right_wheel" type="continuous">»'),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[
        {
            "robot.urdf": geared(geared(ROVER, "left_wheel", "30"), "right_wheel", "-30").replace(
                "mock_components/GenericSystem", "my_driver/Base"
            ),
            "controllers.yaml": WHEELS % "base",
        },
    ],
)
def wheel_reductions_differ(controller: str, least: str, joint: str, most: str, other: str) -> str:
    """Driven wheels with different reductions.

    Hardware that uses the transmissions divides the speed of a motor by the reduction. If the gears are equal in fact,
    one wheel turns faster than the other, and the base drives in circles. The sign may differ: motors are mounted
    mirrored.
    """
    return (
        f"the wheels of controller '{controller}' have different reductions: {least} at '{joint}', {most} at '{other}'"
    )
