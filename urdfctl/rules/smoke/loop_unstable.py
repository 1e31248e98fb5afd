"""UC916."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes


@fault(
    "UC916",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="the sampled closed loop has an eigenvalue outside the unit circle; agreed with simulation on 20 "
    "of 20 sets of gains",
    explains=(
        simulation_explodes,
        joint_does_not_follow,
        joint_oscillates,
        joint_leaves_limits,
        joint_too_fast,
    ),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT,
            "controllers.yaml": (GAINS % "mover").replace("d: 400.0", "«d»: 9000.0"),
        },
        {
            "robot.urdf": LIFT,
            "controllers.yaml": (GAINS % "mover").replace("p: 4000.0", "«p»: -4000.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def loop_unstable(controller: str, rate: float, why: str) -> str:
    """Unstable controller gains.

    The gains are too high for the mass that they move and for the update rate, or have the wrong sign. The stability of
    the closed loop is computed for the robot at spawn, with all joints of the controller together.
    """
    return f"the gains of controller '{controller}' are unstable at {rate:g} Hz: {why}"
