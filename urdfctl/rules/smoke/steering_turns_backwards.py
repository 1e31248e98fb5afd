"""UC961."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import TRICYCLE, TRICYCLE_CONTROLLER


@fault(
    "UC961",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="steering_controllers_library: a positive steering angle turns the wheel to the left",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": TRICYCLE.replace('<axis xyz="0 0 1"/><!-- steer -->', '<axis xyz="0 0 -1"/>').replace(
                '<joint name="steer" type="revolute">', '«<joint name="steer" type="revolute">»'
            ),
            "controllers.yaml": TRICYCLE_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": TRICYCLE, "controllers.yaml": TRICYCLE_CONTROLLER}],
)
def steering_turns_backwards(joint: str, how: str, controller: str) -> str:
    """Steering joint turns the wrong way.

    Its axis points down, or is not upright: the robot turns right when commanded to turn left. Wheels that steer behind
    the driven ones are not checked, because controllers differ in their sign.
    """
    return f"steering joint '{joint}' turns {how} when controller '{controller}' steers left"
