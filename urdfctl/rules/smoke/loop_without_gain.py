"""UC987."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT
from urdfctl.rules.smoke.joint_does_not_follow import joint_does_not_follow
from urdfctl.rules.smoke.joint_leaves_limits import joint_leaves_limits


@fault(
    "UC987",
    severity=Severity.ERROR,
    runtime="misbehaves",
    authority="control_toolbox: the command of a PID is p e + i ∫e + d de/dt; with p and i of 0 no position error commands "
    "anything",
    explains=(joint_does_not_follow, joint_leaves_limits),
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT,
            "controllers.yaml": (GAINS % "mover").replace("p: 4000.0, i: 100.0", "«p»: 0.0, i: 0.0"),
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def loop_without_gain(controller: str, joint: str) -> str:
    """Joint without gains.

    The controller is active, but commands no effort, however far the joint is from its target.
    """
    return f"the gains p and i of controller '{controller}' for joint '{joint}' are 0: nothing moves or holds it"
