"""UC910."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import LIFT


@fault(
    "UC910",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="measured: an engine that is given such a body puts nan into every state of the robot",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('ixx="0.05"', 'ixx="-0.05"').replace(
                '<link name="carriage">', '«<link name="carriage">»'
            )
        },
    ],
    good=[{"robot.urdf": LIFT}],
)
def inertia_unusable(link: str, problem: str) -> str:
    """Mass or inertia is negative or not a finite number.

    No body can have such a mass or inertia. In the first step of a simulation the invalid value spreads over the whole
    robot.
    """
    return f"link '{link}' has a mass or inertia that is {problem}"
