"""UC359."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in

_PLUGIN = "gazebo_ros2_control"


@rule(
    "UC359",
    severity=Severity.WARNING,
    distros=("humble",),
    authority="gazebo_ros2_control#295, gz_ros2_control#503: \"Couldn't parse parameter override rule: '--param "
    'robot_description:=<?xml version="; the plugin hands the description to the controller manager as a '
    "parameter, which is read as YAML",
    bad={
        "robot.urdf": """
            <gazebo>
              <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
            «<!-- TODO: tune the gains -->»
            <ros2_control name="arm" type="system">
              <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <gazebo>
              <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
            <!-- TODO tune the gains -->
            <ros2_control name="arm" type="system">
              <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
)
def comment_breaks_parameter(project: Project) -> Iterator[Finding]:
    """A comment has a colon with a space behind it, or a space with # behind it.

    Gazebo Classic's plugin of humble (from 0.4.7 on) hands the whole description to the controller manager as a
    parameter, which is read as YAML: there a colon and a space make a key, and a space and # a comment. The
    simulation then has no controller manager.
    """
    robot = robot_in(project)
    if robot is None or not any(_PLUGIN in (plugin.filename or "") for plugin in robot.plugins):
        return
    for comment in robot.tag.comments() if robot.tag else ():
        broken = re.search(r":\s|\s#", comment.text)
        if broken:
            what = "a colon with a space behind it" if ":" in broken.group() else "a space with # behind it"
            message = f"this comment has {what}: Gazebo's plugin of humble cannot pass the description on"
            yield Finding(comment.at, message, fix=Fix("take it out of the comment, or the comment out of the file"))
