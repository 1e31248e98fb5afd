"""UC522."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC522",
    runtime="refuses",
    because="the path is right in one folder",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="gz_ros2_control and gazebo_ros2_control pass the text to rcl as --params-file: 'Error opening YAML file'",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>«config/controllers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def controllers_path_relative(project: Project) -> Iterator[Finding]:
    """Controller file is a relative path or a URL.

    A relative path is resolved only in the folder where the simulator was started. URLs such as `package://` are not
    supported.
    """
    for sim_plugin, _, reference in controllers_files(project):
        text = reference.text
        if text.startswith(("/", "~")) or "$" in text or not is_known(text):
            continue
        is_url = "://" in text
        message = (
            f"'{sim_plugin.filename}' looks for relative path '{text}' in the folder where the simulator is started"
        )
        if is_url:
            message = f"'{sim_plugin.filename}' does not support URLs and finds no file '{text}'"
        fix = Fix("write $(find your_package)/... in a .xacro file")
        yield Finding(reference.at, message, fix=fix, severity=Severity.ERROR if is_url else None)
