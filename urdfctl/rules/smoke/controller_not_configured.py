"""UC904."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, Stage, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, found_by_smoke_test


@rule(
    "UC904",
    stage=Stage.CONFIGURE,
    severity=Severity.ERROR,
    runtime="refuses",
    message="controller '{controller}' cannot be configured: {why}",
    authority="controller_manager.cpp: \"After configuring, controller 'arm' is in state 'unconfigured', "
    'expected inactive."',
    options=["--distro=jazzy"],
    bad={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [elbow, «elbow»]")},
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def controller_not_configured(project: Project) -> Iterator[Finding]:
    """Controller cannot be configured.

    Its parameters do not fit together, or a required one is empty. The controller manager of ROS 2 loads the
    controller, but cannot configure it. The note quotes the controller manager.
    """
    return found_by_smoke_test(project)
