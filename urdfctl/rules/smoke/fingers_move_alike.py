"""UC989."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, marked

_WIDE, _BOTH = '<limit lower="0" upper="0.04"', '<limit lower="-0.04" upper="0.04"'
_APART = GRIPPER.replace('<child link="one"/>', '<child link="one"/><origin xyz="0 0.02 0"/>').replace(
    '<child link="two"/>', '<child link="two"/><origin xyz="0 -0.02 0"/>'
)
_TURNING = (
    _APART.replace("prismatic", "revolute")
    .replace('<axis xyz="0 1 0"/>', '<axis xyz="1 0 0"/>')
    .replace('<axis xyz="0 -1 0"/>', '<axis xyz="-1 0 0"/>')
    .replace('<mass value="0.1"/>', '<origin xyz="0 0 0.1"/><mass value="0.1"/>')
)


@fault(
    "UC989",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="a follower moves by the multiplier times the leader, along or about its own axis",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(
                _APART, '<joint name="thumb" type="prismatic">', 'multiplier="1"', 'multiplier="-1"'
            ).replace(_WIDE, _BOTH),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
        {
            "robot.urdf": marked(
                _TURNING, '<joint name="thumb" type="revolute">', 'multiplier="1"', 'multiplier="-1"'
            ).replace(_WIDE, _BOTH),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[
        {"robot.urdf": _APART, "controllers.yaml": GRIPPER_CONTROLLER},
        {"robot.urdf": _TURNING, "controllers.yaml": GRIPPER_CONTROLLER},
    ],
)
def fingers_move_alike(joint: str, leader: str) -> str:
    """Fingers that move to the same side.

    The finger that mimics the other one moves in the same direction, so that the gripper never closes. Its axis is
    already mirrored, or is not: change the sign of either the multiplier or the axis.
    """
    return f"joint '{joint}' moves to the same side as joint '{leader}', which it mimics: these fingers never close"
