"""UC935."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import GAINS, LIFT, told_by_smoke


@rule(
    "UC935",
    severity=Severity.ERROR,
    authority="measured on 35 real robots and 109 hand-made cases, in pybullet and MuJoCo",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": LIFT.replace('<joint name="lift" type="prismatic">', '«<joint name="lift" type="prismatic">»')
        .replace('name="effort"', 'name="velocity"')
        .replace('effort="500"', 'effort="60"')
        .replace('mass value="5"', 'mass value="50"'),
        "controllers.yaml": (GAINS % "mover")
        .replace(
            "joint_trajectory_controller/JointTrajectoryController", "velocity_controllers/JointGroupVelocityController"
        )
        .split("        command_interfaces")[0],
    },
    good={"robot.urdf": LIFT, "controllers.yaml": GAINS % "mover"},
)
def joint_moves_wrong_way(project: Project) -> Iterator[Finding]:
    """A joint does not move as a velocity or an effort tells it, or moves the other way.

    A sign is wrong: of a gain, or of the command's way to the joint; or something holds it.
    """
    return told_by_smoke(project)
