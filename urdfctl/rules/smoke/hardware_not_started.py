"""UC902."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE


@fault(
    "UC902",
    stage=Stage.HARDWARE,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control resource_manager.cpp and component_parser.cpp; ros_control transmission_parser.cpp",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": HARDWARE.replace('type="system"', 'type="«sytem»"'),
            "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
        },
    ],
    good=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")}],
)
def hardware_not_started(why: str) -> str:
    """Hardware cannot be started.

    A ros2_control component, or a transmission in ROS 1, is rejected. The robot is spawned, but no controller can claim
    an interface, so none becomes active.
    """
    return f"the hardware cannot be started: {why}"
