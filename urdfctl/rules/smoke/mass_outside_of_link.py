"""UC982."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC982",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured; the weight of the link pulls with a lever that the robot does not have",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(
                REACHER, '<link name="hand">', '<origin xyz="0 0 0.04"/><mass', '<origin xyz="0 0.8 0.04"/><mass'
            ),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def mass_outside_of_link(link: str, away: float, size: float) -> str:
    """Centre of mass far outside of its link.

    It is farther away from the link's shapes and joints than five times their size. The <origin> of the <inertial> is
    given in the frame of the link, not in that of the CAD model or of the world.
    """
    return f"the mass of link '{link}' lies {away:.3g} m outside of the link, which is {size:.2g} m long"
