"""UC976."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import ROVER, WHEELS, found_by_smoke_test
from urdfctl.rules.smoke.does_not_drive_forward import does_not_drive_forward
from urdfctl.rules.smoke.does_not_turn_left import does_not_turn_left

_SURFACE = "".join(f'<gazebo reference="{name}"><mu1>%s</mu1><mu2>%s</mu2></gazebo>' for name in ("left", "right"))


@rule(
    "UC976",
    stage=Stage.MOVE,
    severity=Severity.ERROR,
    runtime="misbehaves",
    message="the wheels of controller '{controller}' slip: they push with at most {thrust} N, and the robot needs {needed} N",
    authority="Coulomb friction: a contact with the load N pushes with at most mu N; sdformat parser_urdf.cc reads <mu1> and <mu2>",
    explains=(does_not_drive_forward, does_not_turn_left),
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": ROVER.replace("</robot>", f"{_SURFACE % (0, 0, 0, 0)}</robot>"),
        "controllers.yaml": WHEELS % "«base»",
    },
    good={
        "robot.urdf": ROVER.replace("</robot>", f"{_SURFACE % (0.9, 0.9, 0.9, 0.9)}</robot>"),
        "controllers.yaml": WHEELS % "base",
    },
)
def wheels_slip(project: Project) -> Iterator[Finding]:
    """Wheels that slip on the ground.

    The friction of the driven wheels, times the weight that they carry, is less than what drags casters and other parts
    along and accelerates the robot. Give the wheels in `<gazebo reference="...">` more friction, or casters less, or
    put more of the weight on the wheels.
    """
    return found_by_smoke_test(project)
