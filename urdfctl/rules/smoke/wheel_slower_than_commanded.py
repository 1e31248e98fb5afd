"""UC984."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS, marked

_BASE = (
    (WHEELS % "base").rstrip()
    + """
        linear.x.max_velocity: 1.5
        angular.z.max_velocity: 3.0
"""
)


@fault(
    "UC984",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gz_ros2_control and gazebo_ros_control clamp velocities to the joint's limit; diff_drive_controller: linear.x.max_velocity limits what it commands",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(ROVER, '<joint name="left_wheel" type="continuous">', 'velocity="20"', 'velocity="3"'),
            "controllers.yaml": _BASE,
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": _BASE}],
)
def wheel_slower_than_commanded(joint: str, controller: str, how: str, limit: str, most: str, needed: str) -> str:
    """Wheel that is slower than its controller commands.

    Above the wheel's limit the robot drives slower than commanded, and curves become wider or narrower, while the
    controller believes its own speed. Lower the controller's limit, or correct that of the wheel.
    """
    return (
        f"controller '{controller}' may command the robot to {how}, for which wheel '{joint}' needs {needed} rad/s, but "
        f"its limit is {limit} rad/s: {most} m/s at most"
    )
