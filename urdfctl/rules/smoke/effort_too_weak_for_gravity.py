"""UC915."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC915",
    severity=Severity.ERROR,
    authority="gazebo_ros_control and gz_ros2_control clamp efforts to the joint's limit",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('effort="500"', 'effort="20"').replace(
            '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
        ),
        "controllers.yaml": GAINS % "mover",
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def effort_too_weak_for_gravity(project: Project) -> Iterator[Finding]:
    """A joint's effort limit is too small to hold up what hangs on it.

    At spawn the robot sinks, whatever its controller commands. It is worked out from the masses and where they are; joints
    with a limit of 0, which many robots have for want of a better number, are not judged.
    """
    return told_by_smoke(project)
