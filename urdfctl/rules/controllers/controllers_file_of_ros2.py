"""UC402."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in


@rule(
    "UC402",
    severity=Severity.ERROR,
    distros=ROS1,
    authority="ros_control controller_manager/src/controller_manager.cpp: 'Could not load controller 'arm' because the "
    "type was not specified. Did you load the controller configuration on the parameter server?'",
    options=["--distro=noetic"],
    bad={
        "controllers.yaml": """
            controller_manager:
              «ros__parameters»:
                arm: {type: position_controllers/JointGroupPositionController}
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
        """
    },
    good={
        "controllers.yaml": """
            arm:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
        """
    },
)
def controllers_file_of_ros2(project: Project) -> Iterator[Finding]:
    """A controllers' file is written for ROS 2, and the robot is of ROS 1.

    ROS 1 looks for `type` and the other parameters directly below a controller's name. What stands below
    `controller_manager` or `ros__parameters` it takes for names like any other, and no controller is found.
    """
    if project.ros != 1:
        return
    for file in controllers_in(project).files:
        if file.form == 2 and file.told_by:  # noqa: PLR2004 (the generation)
            message = (
                "this file is written for ROS 2, and ROS 1 finds no controller in it: a controller's type and parameters "
                "belong directly below its name"
            )
            why = (Note(f"{project.distro_from} says that it is ROS 1"),) if project.distro_from else ()
            yield Finding(file.told_by[0].at, message, why, severity=None if project.robot else Severity.WARNING)
