"""UC991."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC991",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="urdfdom urdf_parser/src/joint.cpp and sdformat parser_urdf.cc take no position limits of a continuous joint",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(
                REACHER,
                '<joint name="turn" type="continuous">',
                '<joint name="turn" type="revolute">',
                '<joint name="turn" type="continuous">',
            ).replace('upper="3"', 'upper="1"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def continuous_with_limits(joint: str, lower: float, upper: float) -> str:
    """Limits of a continuous joint.

    Simulators, planners and controllers ignore them silently: the joint turns all around. Make the joint revolute.
    """
    return (
        f"joint '{joint}' is continuous, so that its limits of {lower:g} to {upper:g} rad are ignored; make it revolute if "
        "they are real"
    )
