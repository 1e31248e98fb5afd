"""UC951."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_moves_wrong_way import joint_moves_wrong_way


@fault(
    "UC951",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="URDF: the friction of a joint is an effort, and its damping an effort for each unit of speed",
    explains=(
        joint_does_not_follow,
        does_not_drive_forward,
        does_not_turn_left,
        joint_moves_wrong_way,
    ),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace(
                'velocity="1"/>', 'velocity="1"/><dynamics damping="0" friction="600"/>'
            ).replace('<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[
        {
            "robot.urdf": LIFT.replace('velocity="1"/>', 'velocity="1"/><dynamics damping="10" friction="5"/>'),
            "controllers.yaml": GAINS % "mover",
        },
    ],
)
def joint_resists_its_motor(joint: str, what: str, limit: float, unit: str, how: str) -> str:
    """Joint friction or damping uses up the effort limit.

    The motor of the joint cannot overcome its friction, or its damping holds it far below the speed of the test motion.
    Often the number has another unit, or was tuned for a simulator that ignores the effort limit.
    """
    return f"joint '{joint}' has a {what}: with its effort limit of {limit:g} {unit} it moves {how}"
