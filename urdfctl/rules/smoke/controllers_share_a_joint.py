"""UC993."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER

_KIND = "joint_trajectory_controller/JointTrajectoryController"
_BOTH = (
    REACHER_CONTROLLER.rstrip()
    .replace("turn, bend, reach", "turn, bend")
    .replace(f"reacher: {{type: {_KIND}}}", f"reacher: {{type: {_KIND}}}\n        %s: {{type: {_KIND}}}")
    + """
    lifter:
      ros__parameters:
        joints: [%s]
        command_interfaces: [position]
        state_interfaces: [position, velocity]
"""
)
_ALL = _BOTH.replace("joints: [turn, bend]", "joints: [turn, bend, reach]")


@fault(
    "UC993",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="controller_manager refuses to activate a controller whose command interface another one has claimed",
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": REACHER, "controllers.yaml": _BOTH % ("«lifter»", "bend, reach")}],
    good=[
        {"robot.urdf": REACHER, "controllers.yaml": _BOTH % ("lifter", "reach")},
        {"robot.urdf": REACHER, "controllers.yaml": _ALL % ("lifter", "turn, bend, reach")},
    ],
)
def controllers_share_a_joint(controller: str, other: str, joint: str) -> str:
    """Two controllers command one joint, and each has joints of its own.

    Only one of them can be active, so that the joints of the other one cannot be moved at the same time. Take the joint
    out of one of them. With `--start`, or a launch file that starts controllers, lint reports which one is refused.
    """
    return (
        f"controllers '{other}' and '{controller}' both command joint '{joint}', and each has joints of its own: only one "
        "of them can be active"
    )
