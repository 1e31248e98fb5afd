"""UC401."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.controllers.common import controllers_in

_ROS2 = 2


@rule(
    "UC401",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Cannot have a value before ros__parameters at line 2'",
    options=["--distro=humble"],
    bad={
        "robot.urdf": "",
        "controllers.yaml": """
            «arm»:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
        """,
    },
    good={
        "robot.urdf": "",
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                states: {type: joint_state_broadcaster/JointStateBroadcaster}
                arm: {type: position_controllers/JointGroupPositionController}
            arm:
              ros__parameters:
                joints: [shoulder, elbow]
        """,
    },
)
def controllers_file_of_ros1(project: Project) -> Iterator[Finding]:
    """A controllers' file is written for ROS 1, and the robot is of ROS 2.

    ROS 2 reads parameters only below `ros__parameters`, and the types of controllers only below the controller manager.
    A node that is given a file of ROS 1 ends at once.
    """
    if project.ros != _ROS2:
        return
    for file in controllers_in(project).files:
        if file.form == 1 and file.told_by:
            names = [key.text for key in file.told_by]
            message = (
                f"this file is written for ROS 1, and ROS 2 refuses it: the type of {in_words(names, 3)} belongs below "
                "'controller_manager: ros__parameters:', the rest into a section of its own with 'ros__parameters:'"
            )
            severity = None if project.robot else Severity.WARNING  # it may be left over, and nobody reads it
            yield Finding(file.told_by[0].at, message, tuple(_why(project)), severity=severity)


def _why(project: Project) -> Iterator[Note]:
    if project.distro_from:
        yield Note(f"{project.distro_from} says that it is ROS 2")
