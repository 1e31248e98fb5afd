"""UC992."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT
from urdfctl.rules.smoke.effort_too_weak_to_move import effort_too_weak_to_move
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.loop_underdamped import loop_underdamped
from urdfctl.rules.smoke.loop_unstable import loop_unstable

_ARM = (
    LIFT.replace('type="prismatic"', 'type="revolute"')
    .replace('<axis xyz="0 0 1"/>', '<axis xyz="1 0 0"/>')
    .replace(
        '<link name="carriage">',
        '<link name="carriage"><collision><geometry><box size="0.3 0.3 0.3"/></geometry></collision>',
    )
)


@fault(
    "UC992",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="the moment of a body of mass m whose mass lies r from its centre is m r²",
    explains=(loop_unstable, loop_underdamped, effort_too_weak_to_move, joint_does_not_follow, joint_oscillates),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": _ARM.replace('<link name="carriage">', '«<link name="carriage">»').replace(
                '="0.05"', '="500"'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": _ARM, "controllers.yaml": (GAINS % "mover").replace("d: 400.0", "d: 40.0")}],
)
def inertia_too_large(link: str, times: str, mass: str, size: str) -> str:
    """Inertia much too large for the link's mass and size.

    Its motor cannot accelerate it, or its gains let it swing, whatever commands the joint. Often the moments are in
    g mm² or kg mm². The size is the largest dimension of the link's simple shapes.
    """
    return f"link '{link}' has about {times} times the inertia of a body of {mass} kg and {size} m"
