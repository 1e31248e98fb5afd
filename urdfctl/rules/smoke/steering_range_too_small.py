"""UC956."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import TRICYCLE, TRICYCLE_CONTROLLER, found_by_smoke_test


@rule(
    "UC956",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="steering joint '{joint}' of controller '{controller}' turns only by {reach} rad to one side",
    authority="a base with the wheelbase l drives a circle with the radius l / tan(steering angle)",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": TRICYCLE.replace('lower="-0.6"', 'lower="-0.02"').replace(
            '<joint name="steer" type="revolute">', '«<joint name="steer" type="revolute">»'
        ),
        "controllers.yaml": TRICYCLE_CONTROLLER,
    },
    good={"robot.urdf": TRICYCLE, "controllers.yaml": TRICYCLE_CONTROLLER},
)
def steering_range_too_small(project: Project) -> Iterator[Finding]:
    """Steering joint that hardly turns.

    With less than 0.05 rad to a side, a circle has a radius of more than twenty wheelbases.
    """
    return found_by_smoke_test(project)
