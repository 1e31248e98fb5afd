"""UC904."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, told_by_smoke


@rule(
    "UC904",
    severity=Severity.ERROR,
    authority="controller_manager.cpp: \"After configuring, controller 'arm' is in state 'unconfigured', expected inactive.\"",
    options=["--distro=jazzy"],
    bad={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("«arm»", "joints: []")},
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def controller_not_configured(project: Project) -> Iterator[Finding]:
    """The controller manager loads a controller of ROS 2, and cannot configure it.

    Its parameters are there, but do not fit together, or one that it needs is empty. The note has the words in which the
    manager refuses it.
    """
    return told_by_smoke(project)
