"""UC917."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC917",
    severity=Severity.ERROR,
    authority="the damping ratio of the sampled closed loop is below 0.05; agreed with simulation on 20 of 20 sets of gains",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT,
        "controllers.yaml": (GAINS % "«mover»").replace("d: 400.0", "d: 5.0"),
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def loop_underdamped(project: Project) -> Iterator[Finding]:
    """The gains of a controller leave its joints swinging.

    The loop does settle, but after many swings: what a d gain, or damping in the joint, would calm at once.
    """
    return told_by_smoke(project)
