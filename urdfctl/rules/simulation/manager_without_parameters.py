"""UC523."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import Loaded, control_plugins, controllers_files, namespace_of


@rule(
    "UC523",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="rclcpp src/rclcpp/parameter_map.cpp: a section is read by the node of that full name; gz_ros2_control "
    "src/gz_ros2_control_plugin.cpp: the manager is <ros><namespace> with <controller_manager_name>; "
    "ros-controls/ros2_control#1669",
    options=["--distro=jazzy"],
    bad={
        "robot.xacro": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>$(find arm)/config/controllers.yaml</parameters>
                <ros>«<namespace>»left_arm</namespace></ros>
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
    good={
        "robot.xacro": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
                <parameters>$(find arm)/config/controllers.yaml</parameters>
                <ros><namespace>left_arm</namespace></ros>
              </plugin>
            </gazebo>
        """,
        "package.xml": "<package><name>arm</name></package>",
        "config/controllers.yaml": """
            /**/controller_manager:
              ros__parameters:
                update_rate: 100
                joint_state_broadcaster:
                  type: joint_state_broadcaster/JointStateBroadcaster
        """,
    },
)
def manager_without_parameters(project: Project) -> Iterator[Finding]:
    """The controllers' file speaks of no controller manager of the name that the plugin gives its own.

    A section counts for the node of that namespace and name alone. The manager starts with its defaults, knows no
    controllers, and spawners fail: 'The 'type' param was not defined'.
    """
    controllers = project.controllers
    hosts = control_plugins(project)
    if controllers is None or len(hosts) != 1 or project.ros != _ROS_2:
        return
    one = hosts[0]
    files = [reference for host, _, reference in controllers_files(project) if host.plugin is one.plugin]
    namespace, name = _manager(one)
    if not files or not all(reference.exists for reference in files) or not is_known(namespace, name):
        return
    sections = [section for manager in controllers.managers for section in manager.sections]
    shared = any(len(manager.parameters) > len(manager.own) for manager in controllers.managers)
    full = f"{namespace}/{name}"
    if not sections or shared or any(section.names(full) for section in sections):
        return
    setting = one.setting("ros/namespace") or one.setting("controller_manager_name")
    message = f"the controller manager of '{one.filename}' is '{full}', and the controllers' file says nothing to it"
    notes = tuple(Note(f"this section is for '/{section.path.lstrip('/')}'", section.at) for section in sections[:1])
    hint = Note(f"a section '{full}' would be for it, or one '/**/{name}' for that of any namespace")
    yield Finding(setting.at if setting else one.plugin.at, message, (*notes, hint))


def _manager(one: Loaded) -> tuple[str, str]:
    namespace, name = one.setting("ros/namespace"), one.setting("controller_manager_name")
    return namespace_of(namespace.text) if namespace else "", name.text if name and name.text else "controller_manager"


_ROS_2 = 2
