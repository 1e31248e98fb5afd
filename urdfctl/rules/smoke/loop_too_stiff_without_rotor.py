"""UC918."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, LIGHT, told_by_smoke


@rule(
    "UC918",
    severity=Severity.WARNING,
    authority="measured: uniform gains on light wrists, which real motors hold for their rotors' inertia",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIGHT,
        "controllers.yaml": (GAINS % "«mover»").replace("d: 400.0", "d: 30.0"),
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def loop_too_stiff_without_rotor(project: Project) -> Iterator[Finding]:
    """The gains of a controller are too high for its lightest joint as it is described.

    A real motor's rotor, through its gears, adds inertia that no description has, and would calm the joint. Simulators know
    of none, and shake it.
    """
    return told_by_smoke(project)
