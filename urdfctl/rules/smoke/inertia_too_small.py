"""UC957."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC957",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="the moment of a body of mass m whose mass lies r from its centre is m r²",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace(
                '<link name="carriage">',
                '«<link name="carriage">»<collision><geometry><box size="0.3 0.3 0.3"/></geometry></collision>',
            ).replace('="0.05"', '="0.000001"'),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def inertia_too_small(link: str, times: str, mass: str, size: str) -> str:
    """Inertia too small for the link's mass and size.

    The link is moved by efforts, so that its inertia decides how it moves: simulators let it tremble or fly off, and
    gains tuned there do not fit the real robot. The size is the largest dimension of the link's simple shapes.
    """
    return f"link '{link}' has about {times} times less inertia than a body of {mass} kg and {size} m"
