"""UC401."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Note, Project, Severity, Stage, rule
from urdfctl.rules.common import in_words

_ROS2 = 2


@rule(
    "UC401",
    stage=Stage.PARAMETERS,
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="rcl rcl_yaml_param_parser/src/parse.c: 'Cannot have a value before ros__parameters at line 2'",
    options=["--distro=humble"],
    bad=[
        {
            "robot.urdf": "",
            "controllers.yaml": """
                «arm»:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="shoulder"><command_interface name="position"/><state_interface name="position"/></joint>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
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
    ],
)
def controllers_file_of_ros1(project: Project) -> Iterator[Finding]:
    """Controller file for ROS 1 in a ROS 2 project.

    ROS 2 reads parameters only below `ros__parameters`, and controller types only below the controller manager. A node
    that gets a ROS 1 file exits at once. A warning if only a launch file for ROS 1 loads it.
    """
    if project.ros != _ROS2:
        return
    for file in controllers_in(project).files:
        if file.form == 1 and file.told_by:
            names = [key.text for key in file.told_by]
            message = (
                f"controller file is written for ROS 1; ROS 2 rejects it. Move the type of {in_words(names, 3)} below "
                "'controller_manager: ros__parameters:', and the rest to separate sections with 'ros__parameters:'"
            )
            is_loaded = project.robot is not None and not _by_roslaunch(project)
            severity = None if is_loaded else Severity.WARNING  # may be an unused leftover
            yield Finding(file.told_by[0].at, message, tuple(_why(project)), severity=severity)


def _by_roslaunch(project: Project) -> bool:
    """Whether a launch file starts the robot that only ROS 1 can run."""
    return project.launch is not None and project.launch.ros == 1


def _why(project: Project) -> Iterator[Note]:
    if project.distro_from:
        yield Note(f"the project uses ROS 2, according to {project.distro_from}")
