"""UC903."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.smoke.common import CONTROLLERS, HARDWARE, told_by_smoke


@rule(
    "UC903",
    severity=Severity.ERROR,
    authority="controller_manager.cpp: \"Loader for controller 'arm' (type 'x') not found.\"; ROS 1: \"Could not load controller 'arm' because controller type 'x' does not exist.\"",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": HARDWARE,
        "controllers.yaml": (CONTROLLERS % ("«arm»", "joints: [shoulder, elbow]")).replace("/Forward", "/Foward"),
    },
    good={"robot.urdf": HARDWARE, "controllers.yaml": CONTROLLERS % ("arm", "joints: [shoulder, elbow]")},
)
def controller_not_loaded(project: Project) -> Iterator[Finding]:
    """The controller manager does not load a controller.

    Its type does not exist in the distro, or it refuses its parameters as soon as they are declared. In ROS 1 it also takes
    its joints when it is loaded. The note has the words in which the manager refuses it.
    """
    return told_by_smoke(project)
