"""UC965."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, found_by_smoke_test


@rule(
    "UC965",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="joint '{joint}' starts at {start:g} {unit}, but its limits are {lower:g} to {upper:g} {unit}",
    authority="hardware_interface: <param name='initial_value'> is the first value of an interface",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": GRIPPER.replace(
            '<state_interface name="position"/>',
            '<state_interface name="position"><param name="initial_value">0.5</param></state_interface>',
        ).replace('<joint name="finger" type="prismatic">', '«<joint name="finger" type="prismatic">»'),
        "controllers.yaml": GRIPPER_CONTROLLER,
    },
    good={"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER},
)
def initial_position_beyond_limits(project: Project) -> Iterator[Finding]:
    """Initial position outside the joint's limits.

    The simulator starts the joint there: it jumps to its limit at the first step, or planners reject the start state.
    """
    return found_by_smoke_test(project)
