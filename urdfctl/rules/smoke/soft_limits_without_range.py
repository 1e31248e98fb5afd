"""UC990."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked

_SAFETY = '<safety_controller k_position="20" k_velocity="10" soft_lower_limit="{}" soft_upper_limit="{}"/>'


@fault(
    "UC990",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="joint_limits_interface joint_limits_interface.h: PositionJointSoftLimitsHandle::enforceLimits() keeps the "
    "command between the soft limits; joint_limits JointSoftLimiter since ros2_control 4.26",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(
                REACHER, '<joint name="bend" type="revolute">', "<!-- bend -->", _SAFETY.format(1, -1)
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER, '<joint name="bend" type="revolute">', "<!-- bend -->", _SAFETY.format(2.5, 3)
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                REACHER, '<joint name="bend" type="revolute">', "<!-- bend -->", _SAFETY.format(1, 1.5)
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[
        {"robot.urdf": REACHER.replace("<!-- bend -->", _SAFETY.format(-1, 1)), "controllers.yaml": REACHER_CONTROLLER},
        {"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER},
    ],
)
def soft_limits_without_range(joint: str, lower: float, upper: float, unit: str, why: str) -> str:
    """Soft limits that the joint cannot keep.

    The lower soft limit is not below the upper one, or the joint starts outside of them: what enforces soft limits
    pushes the joint or holds it still.
    """
    return f"joint '{joint}' has soft limits of {lower:g} to {upper:g} {unit}, {why}"
