"""UC359."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.source.span import Place, SourceSpan

_PLUGIN = "gazebo_ros2_control"


@rule(
    "UC359",
    runtime="refuses",
    because="only the plugin of Gazebo Classic in humble does",
    severity=Severity.WARNING,
    distros=("humble",),
    authority="gazebo_ros2_control#295, gz_ros2_control#503: \"Couldn't parse parameter override rule: '--param "
    'robot_description:=<?xml version="; the plugin passes the description to the controller manager as a '
    "parameter, which is parsed as YAML",
    bad=[
        {
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
    ],
    good=[
        {
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
        {
            "robot.urdf": """
                <gazebo>
                  <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
                    <parameters>/opt/arm/controllers.yaml</parameters>
                  </plugin>
                </gazebo>
                <!-- TODO: tune the gains -->
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
            "arm.launch.py": """
                import os
                import re
                from launch import LaunchDescription
                from launch_ros.actions import Node


                def generate_launch_description():
                    robot = open(os.path.join(os.path.dirname(__file__), 'robot.urdf')).read()
                    described = {'robot_description': re.sub('<!--.*?-->', '', robot, flags=re.DOTALL)}
                    return LaunchDescription([
                        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[described]),
                    ])
            """,
        },
    ],
)
def comment_breaks_parameter(project: Project) -> Iterator[Finding]:
    """Comment breaks Gazebo Classic's plugin in humble.

    In humble, Gazebo Classic's plugin (0.4.7 and later) passes the whole description to the controller manager as a
    parameter, which is parsed as YAML. There, a colon followed by whitespace makes a key, and `#` after whitespace
    starts a comment. The controller manager then fails to start. A launch file that takes comments out of the
    description, by `re.sub`, prevents it.
    """
    robot = robot_in(project)
    if robot is None or not any(_PLUGIN in (plugin.filename or "") for plugin in robot.plugins):
        return
    if project.launch is not None and any(description.edited for description in project.launch.descriptions):
        return
    for comment in robot.tag.comments() if robot.tag else ():
        broken = re.search(r":\s|\s#", comment.text)
        if broken:
            what = "a colon followed by whitespace" if ":" in broken.group() else "'#' after whitespace"
            message = f"comment contains {what}; Gazebo's plugin in humble cannot pass on the description"
            edits = tuple(_edits(comment.at))
            fix = Fix("remove it from the comment, or delete the comment", edits, safe=bool(edits))
            yield Finding(comment.at, message, fix=fix)


def _edits(at: Place) -> Iterator[Edit]:
    """The edits of a comment that the source contains: a dash instead of the colon, and no `#`."""
    source, span = at.source, at.span
    data = source.data[span.start : span.end]
    for match in re.finditer(rb"[ \t]*:(?=\s)|(?<=\s)#+", data if data.startswith(b"<!--") else b""):
        yield Edit(
            SourceSpan(source, span.start + match.start(), span.start + match.end()), " -" if b":" in match[0] else ""
        )
