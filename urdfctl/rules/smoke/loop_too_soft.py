"""UC966."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC966",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="a PID loop at rest: the weight is p times the error, plus the integral part",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT,
            "controllers.yaml": (GAINS % "«mover»").replace(
                "p: 4000.0, i: 100.0, d: 400.0", "p: 100.0, i: 0.0, d: 40.0"
            ),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def loop_too_soft(controller: str, joint: str, sag: float, unit: str, weight: float, effort: str) -> str:
    """Gains too low to hold the joint.

    The p gain holds the weight at spawn only with a large error, and the integral part does not make up for it within
    two seconds. Raise the p gain, or add a feedforward for gravity.
    """
    return (
        f"the gains of controller '{controller}' let joint '{joint}' sag by {sag:.2g} {unit} under its weight "
        f"of {weight:.3g} {effort}"
    )
