"""UC901."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, told_by_smoke


@rule(
    "UC901",
    severity=Severity.ERROR,
    authority="urdfdom: 'Failed to build tree'; Gazebo, robot_state_publisher and the controller manager all refuse such a description",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": HARDWARE + '<joint name="spare" type="fixed"><parent link="fore"/><child link="«tool»"/></joint>',
        "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]"),
    },
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def robot_not_spawned(project: Project) -> Iterator[Finding]:
    """The robot's description is refused, so that nothing of it is spawned.

    No controller is loaded then. `urdfctl lint` tells all that is wrong with the description; the smoke test tells the
    first of it.
    """
    return told_by_smoke(project)
