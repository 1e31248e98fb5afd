"""UC705."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.migration.common import lacking
from urdfctl.rules.migration.facts import IN_GZ
from urdfctl.rules.simulation.common import loaded


@rule(
    "UC705",
    severity=Severity.INFO,
    distros=ROS2,
    authority="gazebo_ros2_control README: 'gazebo_ros2_control won't be released for Jazzy and Rolling anymore'",
    options=["--distro=humble"],
    bad={
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
    good={
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
)
def plugin_gone_soon(project: Project) -> Iterator[Finding]:
    """The plugin that runs a robot's controllers in the simulator is in this distro, and not in one of the next.

    Those up to the next with long-term support are looked at.
    """
    for one in loaded(project):
        if not (one.hosts_control or one.moves_joints) or any(plugin.deprecated for plugin in one.known):
            continue
        gone = lacking(project, one.distros)
        if gone:
            message = f"'{one.filename}' is in {project.distro}, and no more in {gone}"
            instead = IN_GZ.get(one.library)
            yield Finding(one.plugin.at["filename"], message, fix=Fix(f"in gz it is {instead}") if instead else None)
