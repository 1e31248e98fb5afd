"""UC905."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, told_by_smoke


@rule(
    "UC905",
    severity=Severity.ERROR,
    authority="controller_manager.cpp: \"Unable to activate controller 'arm' since the command interface 'wrist/position' is not available.\"; ROS 1: 'Could not switch controllers, due to resource conflict'",
    options=["--distro=jazzy"],
    bad={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("«arm»", "joints: [shoulder, wrist]")},
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def controller_not_activated(project: Project) -> Iterator[Finding]:
    """The controller manager configures a controller, and cannot activate it (ROS 1: start it).

    An interface that it claims is offered by nobody, or another controller that was started before it has it already. The
    note has the words in which the manager refuses it.
    """
    return told_by_smoke(project)
