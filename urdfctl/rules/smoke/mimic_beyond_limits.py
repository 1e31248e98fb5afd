"""UC953."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GRIPPER, GRIPPER_CONTROLLER, found_by_smoke_test
from urdfctl.rules.smoke.mimic_not_kept import mimic_not_kept


@rule(
    "UC953",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="joint '{joint}' mimics joint '{leader}' from {least:.3g} to {most:.3g} {unit}, but its own limits are {lower:.3g} to "
    "{upper:.3g} {unit}",
    authority="URDF: a mimic joint is at multiplier * leader + offset; limits hold for it as for every joint",
    explains=(mimic_not_kept,),
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": GRIPPER.replace('multiplier="1"', 'multiplier="2"').replace(
            '<joint name="thumb" type="prismatic">', '«<joint name="thumb" type="prismatic">»'
        ),
        "controllers.yaml": GRIPPER_CONTROLLER,
    },
    good={"robot.urdf": GRIPPER, "controllers.yaml": GRIPPER_CONTROLLER},
)
def mimic_beyond_limits(project: Project) -> Iterator[Finding]:
    """Mimic joint would exceed its limits.

    Where the leader goes, the mimic joint cannot follow: it stops at its limit, and holds the leader or loses it.
    """
    return found_by_smoke_test(project)
