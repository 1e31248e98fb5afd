"""UC983."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import REACHER, REACHER_CONTROLLER, marked


@fault(
    "UC983",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="REP 103: masses are in kilograms; no material is denser than 22 600 kg/m³",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": marked(REACHER, '<link name="hand">', 'mass value="0.2"', 'mass value="200"'),
            "controllers.yaml": REACHER_CONTROLLER,
        },
    ],
    good=[{"robot.urdf": REACHER, "controllers.yaml": REACHER_CONTROLLER}],
)
def mass_in_grams(link: str, mass: float, litres: float, times: float) -> str:
    """Mass that is most likely in grams.

    The link would be denser than any material, and is much heavier than the usual link of the robot: motors cannot
    hold it, or the simulation is not stable.
    """
    return (
        f"mass of link '{link}' is {mass:g} kg in {litres:.2g} l, {times:.2g} times as dense as lead: most likely grams; "
        f"in kg it is {mass / 1000:g}"
    )
