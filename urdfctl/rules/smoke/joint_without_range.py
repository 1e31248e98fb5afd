"""UC967."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC967",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="Gazebo and MuJoCo stop a joint at its limits; urdfdom urdf_parser/src/joint.cpp parseJointLimits(): "
    "lower and upper default to 0",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('lower="-0.4" upper="0.4" ', 'lower="0.2" upper="0.2" ').replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def joint_without_range(joint: str, lower: float, upper: float, controller: str) -> str:
    """Controlled joint whose limits leave no range of motion.

    The lower limit is not below the upper one: both are equal, both are missing, or they are swapped. The controller is
    active, but the joint stays where it is.
    """
    return (
        f"joint '{joint}' has no range of motion (lower {lower:g}, upper {upper:g}), so controller "
        f"'{controller}' cannot move it"
    )
