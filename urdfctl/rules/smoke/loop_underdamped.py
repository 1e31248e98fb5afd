"""UC917."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC917",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="the damping ratio of the sampled closed loop is below 0.05; agreed with simulation on 20 of 20 "
    "sets of gains",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT,
            "controllers.yaml": (GAINS % "mover").replace("d: 400.0", "«d»: 5.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def loop_underdamped(controller: str, which: str, ratio: float, least: float) -> str:
    """Underdamped controller gains.

    The joints settle only after many swings. A d gain, or damping in the joints, stops them sooner.
    """
    return (
        f"the gains of controller '{controller}' leave {which} swinging: the damping ratio is {ratio:.2g}, "
        f"but should be at least {least:g}"
    )
