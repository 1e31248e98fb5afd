"""UC902."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, told_by_smoke


@rule(
    "UC902",
    severity=Severity.ERROR,
    authority="ros2_control resource_manager.cpp and component_parser.cpp; ros_control transmission_parser.cpp",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": HARDWARE.replace('type="system"', 'type="«sytem»"'),
        "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
    },
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def hardware_not_started(project: Project) -> Iterator[Finding]:
    """The robot's hardware is refused: a component of ros2_control, or a transmission of ROS 1.

    The robot stands, but no controller can claim anything, and none of them becomes active.
    """
    return told_by_smoke(project)
