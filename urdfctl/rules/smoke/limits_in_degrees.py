"""UC978."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.model.degrees import limits_in_words
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC978",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="REP 103: angles are in radians; urdf: <limit> lower and upper are in radians",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(
                REACHER, '<joint name="bend" type="revolute">', 'lower="-2" upper="2"', 'lower="-115" upper="115"'
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def limits_in_degrees(joint: str, lower: float, upper: float) -> str:
    """Limits of a joint that are most likely in degrees.

    The joint is taken to turn several times around: planners and commands go through its mechanical end. A joint that
    really turns several times, like a winch, has limits like these: suppress the finding there. Lint finds the same as
    UC167.
    """
    return limits_in_words(joint, lower, upper)
