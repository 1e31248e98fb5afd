"""UC971."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC971",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="refuses",
    message="controller '{controller}' does not perform its task: {what}",
    authority="the file given with --tasks; joint_trajectory_controller aborts a goal outside its tolerances: "
    "'Aborted due goal_time_tolerance exceeding'",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def task_not_performed(project: Project) -> Iterator[Finding]:
    """Task is not performed.

    The file given with `--tasks` asks a controller for a motion, and at its end, or on the way, a joint or the base is
    not where it should be. Check gains and effort limits, give it more time, or widen the tolerance.
    """
    return found_by_smoke_test(project)
