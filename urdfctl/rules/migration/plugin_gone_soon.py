"""UC705."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.gazebo_plugins import IN_GZ
from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.migration.common import lacking


@rule(
    "UC705",
    severity=Severity.INFO,
    runtime="works",
    distros=ROS2,
    authority="gazebo_ros2_control README: 'gazebo_ros2_control won't be released for Jazzy and Rolling anymore'",
    options=["--distro=humble"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="«libgazebo_ros2_control.so»" name="gazebo_ros2_control">
                    <parameters>/opt/arm/controllers.yaml</parameters>
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
def plugin_gone_soon(project: Project) -> Iterator[Finding]:
    """Simulator plugin is missing in a later distro.

    The plugin runs the robot's controllers in the simulator. The rule checks the distros up to the next one with
    long-term support.
    """
    for plugin in loaded_plugins(project):
        if not (plugin.hosts_control or plugin.moves_joints) or any(entry.deprecated for entry in plugin.known):
            continue
        gone = lacking(project, plugin.distros)
        if gone:
            message = f"plugin '{plugin.filename}' exists in {project.distro} but not in {gone}"
            instead = IN_GZ.get(plugin.library)
            yield Finding(plugin.plugin.at["filename"], message, fix=Fix(f"in gz use {instead}") if instead else None)
