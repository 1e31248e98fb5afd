"""UC903."""

from __future__ import annotations

from urdfctl.fault import Severity, Stage, fault
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE


@fault(
    "UC903",
    stage=Stage.LOAD,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="controller_manager.cpp: \"Loader for controller 'arm' (type 'x') not found.\"; ROS 1: \"Could not "
    "load controller 'arm' because controller type 'x' does not exist.\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": HARDWARE,
            "controllers.yaml": (CONTROLLERS % ("arm", "joints: [shoulder, elbow]")).replace(
                "forward_command_controller/ForwardCommandController",
                "«forward_command_controller/FowardCommandController»",
            ),
        },
    ],
    good=[{"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")}],
)
def controller_not_loaded(controller: str, why: str) -> str:
    """Controller cannot be loaded.

    Its type does not exist in the ROS distro, or it rejects its parameters when it declares them. In ROS 1 a controller
    also claims its joints when it is loaded. The note quotes the controller manager.
    """
    return f"controller '{controller}' cannot be loaded: {why}"
