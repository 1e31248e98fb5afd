"""UC953."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER
from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept


@fault(
    "UC953",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="URDF: a mimic joint is at multiplier * leader + offset; limits hold for it as for every joint",
    explains=(mimic_not_kept,),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": GRIPPER.replace('multiplier="1"', 'multiplier="2"').replace(
                '<joint name="thumb" type="prismatic">', '«<joint name="thumb" type="prismatic">»'
            ),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER}],
)
def mimic_beyond_limits(
    joint: str, leader: str, least: float, most: float, unit: str, lower: float, upper: float
) -> str:
    """Mimic joint would exceed its limits.

    Where the leader goes, the mimic joint cannot follow: it stops at its limit, and holds the leader or loses it.
    """
    return (
        f"joint '{joint}' mimics joint '{leader}' from {least:.3g} to {most:.3g} {unit}, but its own limits "
        f"are {lower:.3g} to {upper:.3g} {unit}"
    )
