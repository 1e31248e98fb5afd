"""UC916."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC916",
    severity=Severity.ERROR,
    authority="the sampled closed loop has an eigenvalue outside the unit circle; agreed with simulation on 20 of 20 sets of gains",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT,
        "controllers.yaml": (GAINS % "«mover»").replace("d: 400.0", "d: 9000.0"),
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def loop_unstable(project: Project) -> Iterator[Finding]:
    """The gains of a controller make its joints swing ever more.

    They are too high for the mass that they move and for how often the controller is updated, or of the wrong sign. It is
    worked out for the robot at spawn, all joints of the controller together.
    """
    return told_by_smoke(project)
