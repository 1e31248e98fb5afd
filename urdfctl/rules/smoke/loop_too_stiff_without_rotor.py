"""UC918."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT, LIGHT
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits
from urdfctl.rules.smoke.joint_oscillates import joint_oscillates
from urdfctl.rules.smoke.joint_too_fast import joint_too_fast
from urdfctl.rules.smoke.joints_oscillate_together import joints_oscillate_together
from urdfctl.rules.smoke.simulation_explodes import simulation_explodes


@fault(
    "UC918",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured: uniform gains on light wrists, which real motors hold for their rotors' inertia",
    explains=(
        simulation_explodes,
        joint_does_not_follow,
        joint_oscillates,
        joints_oscillate_together,
        joint_leaves_limits,
        joint_too_fast,
    ),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIGHT,
            "controllers.yaml": (GAINS % "«mover»").replace("d: 400.0", "d: 30.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def loop_too_stiff_without_rotor(controller: str, which: str, rate: float) -> str:
    """Gains too high for the lightest joint as described.

    The rotor of a real motor adds inertia through its gears, which steadies the joint. Robot descriptions and
    simulators do not model rotors, so the joint shakes in simulation.
    """
    return f"the gains of controller '{controller}' are too high for {which} at {rate:g} Hz"
