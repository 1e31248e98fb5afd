"""UC523."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, control_plugins, namespace_of
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.simulation.common import controllers_files


@rule(
    "UC523",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="rclcpp src/rclcpp/parameter_map.cpp: a section is read only by the node of that full name; gz_ros2_control "
    "src/gz_ros2_control_plugin.cpp: the manager is <ros><namespace> with <controller_manager_name>; "
    "ros-controls/ros2_control#1669",
    options=["--distro=jazzy"],
    bad=[
        {
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
    ],
)
def manager_without_parameters(project: Project) -> Iterator[Finding]:
    """Controller file has no section for the plugin's controller manager.

    A section applies only to the node with that namespace and name. The manager starts with its defaults and knows no
    controllers. Spawners fail with 'The 'type' param was not defined'.
    """
    controllers = project.controllers
    hosts = control_plugins(project)
    if controllers is None or len(hosts) != 1 or project.ros != _ROS_2:
        return
    sim_plugin = hosts[0]
    files = [reference for host, _, reference in controllers_files(project) if host.plugin is sim_plugin.plugin]
    namespace, name = _manager(sim_plugin)
    if not files or not all(reference.exists for reference in files) or not is_known(namespace, name):
        return
    sections = [section for manager in controllers.managers for section in manager.sections]
    shared = any(len(manager.parameters) > len(manager.own) for manager in controllers.managers)
    full = f"{namespace}/{name}"
    if not sections or shared or any(section.names(full) for section in sections):
        return
    setting = sim_plugin.setting("ros/namespace") or sim_plugin.setting("controller_manager_name")
    message = (
        f"controller manager of '{sim_plugin.filename}' is '{full}', but the controller file has no section for it"
    )
    notes = tuple(Note(f"this section is for '/{section.path.lstrip('/')}'", section.at) for section in sections[:1])
    hint = Note(f"add a section '{full}', or '/**/{name}' for any namespace")
    yield Finding(setting.at if setting else sim_plugin.plugin.at, message, (*notes, hint))


def _manager(sim_plugin: LoadedPlugin) -> tuple[str, str]:
    namespace, name = sim_plugin.setting("ros/namespace"), sim_plugin.setting("controller_manager_name")
    return namespace_of(namespace.text) if namespace else "", name.text if name and name.text else "controller_manager"


_ROS_2 = 2
