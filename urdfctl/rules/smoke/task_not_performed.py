"""UC971."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC971",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="the file given with --tasks; joint_trajectory_controller aborts a goal outside its tolerances: "
    "'Aborted due goal_time_tolerance exceeding'",
    options=["--distro=jazzy"],
    bad=[],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def task_not_performed(controller: str, what: str) -> str:
    """Task is not performed.

    The file given with `--tasks` asks a controller for a motion, and at its end, or on the way, a joint or the base is
    not where it should be. Check gains and effort limits, give it more time, or widen the tolerance.
    """
    return f"controller '{controller}' does not perform its task: {what}"
