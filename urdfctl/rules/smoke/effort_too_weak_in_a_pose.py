"""UC950."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, found_by_smoke_test


@rule(
    "UC950",
    stage=Stage.MOVE,
    severity=Severity.WARNING,
    runtime="misbehaves",
    message="joint '{joint}' needs up to {needed:.3g} {unit} to hold the robot, but its effort limit is {limit:g} {unit}: "
    "{margin}",
    authority="gazebo_ros_control and gz_ros2_control clamp efforts to the joint's limit",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('effort="500"', 'effort="50"').replace(
            '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
        ),
        "controllers.yaml": GAINS % "mover",
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def effort_too_weak_in_a_pose(project: Project) -> Iterator[Finding]:
    """Effort limit with hardly any margin, or too low in some pose.

    The load of gravity is computed at spawn and in poses spread over the joints' ranges; the note names the worst one.
    A margin under 5 % leaves nothing to accelerate with. The note is missing if the load is the same in every pose.
    """
    return found_by_smoke_test(project)
