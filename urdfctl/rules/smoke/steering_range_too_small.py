"""UC956."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import TRICYCLE, TRICYCLE_CONTROLLER


@fault(
    "UC956",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="a base with the wheelbase l drives a circle with the radius l / tan(steering angle)",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": TRICYCLE.replace('lower="-0.6"', 'lower="-0.02"').replace(
                '<joint name="steer" type="revolute">', '«<joint name="steer" type="revolute">»'
            ),
            "controllers.yaml": TRICYCLE_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": TRICYCLE, "controllers.yaml": TRICYCLE_CONTROLLER}],
)
def steering_range_too_small(joint: str, controller: str, reach: str) -> str:
    """Steering joint that hardly turns.

    With less than 0.05 rad to a side, a circle has a radius of more than twenty wheelbases.
    """
    return f"steering joint '{joint}' of controller '{controller}' turns only by {reach} rad to one side"
