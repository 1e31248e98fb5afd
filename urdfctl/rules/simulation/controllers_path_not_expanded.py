"""UC521."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC521",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros-controls/gazebo_ros2_control#141 and #155: 'Error opening YAML file' with the literal '$(find ...)': nothing "
    "but xacro expands it",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>«$(find arm)/config/controllers.yaml»</parameters>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.xacro": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>$(find arm)/config/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
        "package.xml": "<package><name>arm</name></package>",
        "config/controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                joint_state_broadcaster:
                  type: joint_state_broadcaster/JointStateBroadcaster
        """,
    },
)
def controllers_path_not_expanded(project: Project) -> Iterator[Finding]:
    """The name of the controllers' file still holds `$(find ...)` or `${...}`.

    Xacro works these out, and nobody else: in a plain URDF the simulator looks for a file of that very name. All is
    well only where the launch file gives the URDF to xacro after all.
    """
    for one, _, reference in controllers_files(project):
        text = reference.text
        if is_known(text) and ("$(" in text or "${" in text):
            message = (
                f"'{text}' stands here as it is, and '{one.filename}' finds no file of that name: only xacro expands it"
            )
            fix = Fix("name the file .xacro and let the launch file call xacro, or write the whole path")
            yield Finding(reference.at, message, fix=fix)
