"""UC933."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC933",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'),
        "controllers.yaml": (GAINS % "mover").replace("d: 400.0", "d: 0.0"),
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_oscillates(project: Project) -> Iterator[Finding]:
    """A joint swings where it should stand still.

    The gains of its loop are too high, or nothing damps it.
    """
    return told_by_smoke(project)
