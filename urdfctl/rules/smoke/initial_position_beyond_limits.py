"""UC965."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER


@fault(
    "UC965",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="hardware_interface: <param name='initial_value'> is the first value of an interface",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": GRIPPER.replace(
                '<state_interface name="position"/>',
                '<state_interface name="position"><param name="initial_value">0.5</param></state_interface>',
            ).replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def initial_position_beyond_limits(joint: str, start: float, unit: str, lower: float, upper: float) -> str:
    """Initial position outside the joint's limits.

    The simulator starts the joint there: it jumps to its limit at the first step, or planners reject the start state.
    """
    return f"joint '{joint}' starts at {start:g} {unit}, but its limits are {lower:g} to {upper:g} {unit}"
