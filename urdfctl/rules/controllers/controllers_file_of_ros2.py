"""UC402."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule


@rule(
    "UC402",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS1,
    authority="ros_control controller_manager/src/controller_manager.cpp: 'Could not load controller 'arm' because the "
    "type was not specified. Did you load the controller configuration on the parameter server?'",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  «ros__parameters»:
                    arm: {type: position_controllers/JointGroupPositionController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                arm:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """
        },
    ],
)
def controllers_file_of_ros2(project: Project) -> Iterator[Finding]:
    """Controller file for ROS 2 in a ROS 1 project.

    ROS 1 expects `type` and the other parameters directly below a controller's name. It treats `controller_manager` and
    `ros__parameters` as ordinary names, and finds no controller.
    """
    if project.ros != 1:
        return
    for file in controllers_in(project).files:
        if file.form == 2 and file.told_by:  # noqa: PLR2004 (the generation)
            message = (
                "controller file is written for ROS 2; ROS 1 finds no controller in it. "
                "Put a controller's type and parameters directly below its name"
            )
            why = (Note(f"the project uses ROS 1, according to {project.distro_from}"),) if project.distro_from else ()
            is_loaded = project.robot is not None and project.launch is not None
            yield Finding(file.told_by[0].at, message, why, severity=None if is_loaded else Severity.WARNING)
