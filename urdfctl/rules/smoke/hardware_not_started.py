"""UC902."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, found_by_smoke_test


@rule(
    "UC902",
    stage=Stage.HARDWARE,
    severity=Severity.ERROR,
    runtime="refuses",
    message="the hardware cannot be started: {why}",
    authority="ros2_control resource_manager.cpp and component_parser.cpp; ros_control transmission_parser.cpp",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": HARDWARE.replace('type="system"', 'type="«sytem»"'),
        "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
    },
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def hardware_not_started(project: Project) -> Iterator[Finding]:
    """Hardware cannot be started.

    A ros2_control component, or a transmission in ROS 1, is rejected. The robot is spawned, but no controller can claim
    an interface, so none becomes active.
    """
    return found_by_smoke_test(project)
