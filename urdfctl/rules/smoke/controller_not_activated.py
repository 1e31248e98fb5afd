"""UC905."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, found_by_smoke_test


@rule(
    "UC905",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    message="controller '{controller}' cannot be activated: {why}",
    authority="controller_manager.cpp: \"Unable to activate controller 'arm' since the command interface "
    "'wrist/position' is not available.\"; ROS 1: 'Could not switch controllers, due to resource conflict'",
    options=["--distro=jazzy"],
    bad={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, «wrist»]")},
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def controller_not_activated(project: Project) -> Iterator[Finding]:
    """Controller cannot be activated.

    It claims an interface that does not exist, or that another controller has already claimed. ROS 1 calls this stage
    starting. The note quotes the controller manager.
    """
    return found_by_smoke_test(project)
