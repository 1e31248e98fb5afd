"""UC963."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC963",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="{engine} and {others} disagree; only {engine} reports: {what}",
    authority="measured: pybullet's damping is explicit, and its wheels slip when a base with four of them turns",
    options=["--distro=jazzy"],
    bad={},
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def engines_disagree(project: Project) -> Iterator[Finding]:
    """Physics engines disagree.

    With `--engine both`, only one engine sees the controller fail. One of them is wrong, or the robot is on the edge:
    read what the engine reports, and decide. Such a controller does not fail.
    """
    return found_by_smoke_test(project)
