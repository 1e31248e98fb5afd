"""UC950."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.smoke.common import GAINS, LIFT


@fault(
    "UC950",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="gazebo_ros_control and gz_ros2_control clamp efforts to the joint's limit",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": LIFT.replace('effort="500"', 'effort="50"').replace(
                '<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»'
            ),
            "controllers.yaml": GAINS % "mover",
        },
    ],
    good=[{"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"}],
)
def effort_too_weak_in_a_pose(joint: str, needed: float, unit: str, limit: float, margin: str) -> str:
    """Effort limit with hardly any margin, or too low in some pose.

    The load of gravity is computed at spawn and in poses spread over the joints' ranges; the note names the worst one.
    A margin under 5 % leaves nothing to accelerate with. The note is missing if the load is the same in every pose.
    """
    return (
        f"joint '{joint}' needs up to {needed:.3g} {unit} to hold the robot, but its effort limit is "
        f"{limit:g} {unit}: {margin}"
    )
