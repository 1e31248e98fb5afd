"""UC520."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.file_names import file_renamed, meant_file
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC520",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="gazebo_ros2_control src/gazebo_ros2_control_plugin.cpp: 'parser error Couldn't parse params file ... Error "
    "opening YAML file'; rcl rcl_yaml_param_parser/src/parser.c",
    bad=[
        {
            "robot.xacro": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>«$(find arm)/config/controlers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
            "package.xml": "<package><name>arm</name></package>",
        },
    ],
    good=[
        {
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
    ],
)
def controllers_file_missing(project: Project) -> Iterator[Finding]:
    """Controller file of a simulator plugin does not exist.

    The plugin exits, and often the simulator with it. If the path contains an argument, another value may name an
    existing file. In that case this is a warning.
    """
    for sim_plugin, tag, reference in controllers_files(project):
        if reference.exists is False:
            written = tag.at.content.span.text
            chosen = "$(arg" in written or "${" in written
            message = f"controller file of '{sim_plugin.filename}' does not exist: '{written}'{meant_file(reference)}"
            severity = Severity.WARNING if chosen else None
            yield Finding(reference.at, message, fix=file_renamed(reference), severity=severity)
