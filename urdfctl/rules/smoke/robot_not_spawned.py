"""UC901."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, found_by_smoke_test


@rule(
    "UC901",
    stage=Stage.SPAWN,
    severity=Severity.ERROR,
    runtime="refuses",
    message="the robot cannot be spawned: {why}",
    authority="urdfdom: 'Failed to build tree'; Gazebo, robot_state_publisher and the controller manager all "
    "refuse such a description",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": HARDWARE + '<joint name="spare" type="fixed"><parent link="fore"/><child link="«tool»"/></joint>',
        "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
    },
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def robot_not_spawned(project: Project) -> Iterator[Finding]:
    """Robot cannot be spawned.

    The robot description is rejected, so no controller is loaded. The smoke test reports the first error of the
    description; `urdfctl lint` reports all of them.
    """
    return found_by_smoke_test(project)
