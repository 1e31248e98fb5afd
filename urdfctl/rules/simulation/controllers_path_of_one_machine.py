"""UC531."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.simulation.common import controllers_files

_HOMES = ("/home/", "/root/", "/Users/")


@rule(
    "UC531",
    runtime="works",
    because="other machines do not have the file, and there the controller manager does not start",
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
                    <parameters>«/home/me/ws/install/arm/share/arm/config/controllers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>«/root/ws/controllers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>«/Users/me/ws/controllers.yaml»</parameters>
                  </plugin>
                </gazebo>
            """,
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
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
            """,
        },
    ],
)
def controllers_path_of_one_machine(project: Project) -> Iterator[Finding]:
    """Absolute path of the controller file in a user's folder.

    The file is found only on the machine where the path was written. Elsewhere the simulator's plugin exits with
    'Error opening YAML file', and the spawners wait for a controller manager.
    """
    for _, tag, reference in controllers_files(project):
        text = reference.text.strip()
        if text.startswith(_HOMES) and tag.at.content.span.text.strip() == text:
            fix = Fix("write $(find your_package)/... in a .xacro file")
            yield Finding(reference.at, f"controller file '{text}' exists on one machine only", fix=fix)
