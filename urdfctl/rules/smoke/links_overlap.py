"""UC968."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER

_BOX = '<collision><origin xyz="0 {y} 0"/><geometry><box size="0.02 0.06 0.02"/></geometry></collision>'
_BAD = GRIPPER.replace('<link name="one">', '«<link name="one">»' + _BOX.format(y="0.01")).replace(
    '<link name="two">', '<link name="two">' + _BOX.format(y="-0.01")
)


@fault(
    "UC968",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured; MoveIt finds no plan from there ('Start state appears to be in collision'), and a simulator "
    "with self-collision pushes the links apart",
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": _BAD, "controllers.yaml": GRIPPER_CONTROLLER}],
    good=[
        {
            "robot.urdf": _BAD.replace('"0 0.01 0"', '"0 0.04 0"')
            .replace('"0 -0.01 0"', '"0 -0.04 0"')
            .replace("«", "")
            .replace("»", ""),
            "controllers.yaml": GRIPPER_CONTROLLER,
        },
    ],
)
def links_overlap(link: str, other: str, when: str) -> str:
    """Links overlap at spawn or with all joints at 0.

    The collision geometry of two links that are not neighbours takes the same space. Meshes are not looked at. Correct
    the geometry, or allow the pair with <disable_collisions> in the SRDF.
    """
    return f"links '{link}' and '{other}' overlap {when}"
