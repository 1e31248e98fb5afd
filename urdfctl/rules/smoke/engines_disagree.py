"""UC963."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC963",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="measured: pybullet's damping is explicit, and its wheels slip when a base with four of them turns",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def engines_disagree(engine: str, others: str, what: str) -> str:
    """Physics engines disagree.

    Only one engine sees the controller fail, with `--engine both` or where `auto` asked a second one. One of them is wrong, or the robot is on the edge:
    read what the engine reports, and decide. Such a controller does not fail.
    """
    return f"{engine} and {others} disagree; only {engine} reports: {what}"
