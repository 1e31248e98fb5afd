"""UC905."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE


@fault(
    "UC905",
    stage=Stage.ACTIVATE,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="controller_manager.cpp: \"Unable to activate controller 'arm' since the command interface "
    "'wrist/position' is not available.\"; ROS 1: 'Could not switch controllers, due to resource conflict'",
    options=["--distro=jazzy"],
    bad=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, «wrist»]")}],
    good=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")}],
)
def controller_not_activated(controller: str, why: str) -> str:
    """Controller cannot be activated.

    It claims an interface that does not exist, or that another controller has already claimed. ROS 1 calls this stage
    starting. The note quotes the controller manager.
    """
    return f"controller '{controller}' cannot be activated: {why}"
