"""UC985."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import ROVER, WHEELS, marked

_LEFT = '<inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.003"/></inertial>\n        <collision>'
_OFF = _LEFT + '<origin xyz="0.03 0 0"/>'


@fault(
    "UC985",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured: a wheel that turns off its middle lifts the robot once in each turn",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(ROVER, '<link name="left">').replace(_LEFT, _OFF, 1),
            "controllers.yaml": WHEELS % "base",
        },
    ],
    good=[{"robot.urdf": ROVER, "controllers.yaml": WHEELS % "base"}],
)
def wheel_eccentric(joint: str, controller: str, off: float) -> str:
    """Wheel that turns off its middle.

    The middle of its collision geometry is not on the joint's axis: the robot limps and slips. Move the <collision> or
    the joint's <origin>.
    """
    return f"wheel '{joint}' of controller '{controller}' turns about an axis that is {off:.2g} m off its middle"
