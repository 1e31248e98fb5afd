"""UC914."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC914",
    severity=Severity.ERROR,
    authority="gazebo_ros_control and gz_ros2_control clamp velocities to the joint's limit",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('velocity="1"', 'velocity="0"').replace(
            '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
        ),
        "controllers.yaml": GAINS % "mover",
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_held_still(project: Project) -> Iterator[Finding]:
    """A controller is to move a joint whose velocity limit is 0.

    Simulators and drivers take the limit at its word: the controller is active, and nothing moves.
    """
    return told_by_smoke(project)
