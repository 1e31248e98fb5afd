"""UC979."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC979",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="REP 103: lengths are in metres; urdf: <limit> of a prismatic joint is in metres",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(REACHER, '<joint name="reach" type="prismatic">', 'upper="0.2"', 'upper="200"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def travel_in_millimetres(joint: str, travel: float, size: float, least: float, most: float) -> str:
    """Limits of a prismatic joint that are most likely in mm.

    The joint travels much farther than the robot is long.
    """
    return (
        f"joint '{joint}' has limits that let it travel {travel:g} m, but the robot is {size:.2g} m long: most likely "
        f"millimetres; in m they are {least:g} to {most:g}"
    )
