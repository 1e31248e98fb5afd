"""UC904."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE


@fault(
    "UC904",
    stage=Stage.CONFIGURE,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="controller_manager.cpp: \"After configuring, controller 'arm' is in state 'unconfigured', "
    'expected inactive."',
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [elbow, «elbow»]")}],
    good=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")}],
)
def controller_not_configured(controller: str, why: str) -> str:
    """Controller cannot be configured.

    Its parameters do not fit together, or a required one is empty. The controller manager of ROS 2 loads the
    controller, but cannot configure it. The note quotes the controller manager.
    """
    return f"controller '{controller}' cannot be configured: {why}"
