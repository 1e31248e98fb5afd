"""UC511."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import renamed
from urdfctl.rules.simulation.common import Unread, namespace_of, unread_settings


@rule(
    "UC511",
    severity=Severity.WARNING,
    authority="gazebo_ros_pkgs: in ROS 2 the settings of plugins are written_like_this, in ROS 1 writtenLikeThis; sdformat "
    "Element::HasElement compares the names as they are, and nobody asks for the others",
    options=["--distro=galactic"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
                «<robotNamespace>»/arm</robotNamespace>
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
                <ros><namespace>/arm</namespace></ros>
                <parameters>/opt/arm/controllers.yaml</parameters>
              </plugin>
            </gazebo>
        """,
    },
)
def plugin_setting_misspelt(project: Project) -> Iterator[Finding]:
    """A plugin's setting is spelt otherwise than the plugin reads it, or as the other ROS has it.

    The plugin asks for its settings by name, and takes its default where it finds none: what is written is lost without
    a word.
    """
    for unread in unread_settings(project):
        if unread.meant is None:
            continue
        shown = unread.shown
        fix = Fix(f"write {shown}")
        if unread.meant in unread.one.children and "/" not in unread.name + unread.meant:
            fix = Fix(f"write {shown}", renamed(unread.tag, unread.meant), safe=unread.same)
        message = f"'{unread.one.filename}' does not read <{unread.name.removeprefix('ros/')}>; it is {shown}"
        severity = Severity.INFO if unread.harmless else None
        yield Finding(unread.tag.at, message, tuple(_notes(project, unread)), fix, severity)


def _notes(project: Project, unread: Unread) -> Iterator[Note]:
    """That a namespace is none that the controllers are configured in."""
    managers = project.controllers.managers if project.controllers else ()
    namespace = namespace_of(unread.tag.text)
    if unread.meant == "ros/namespace" and managers and all(m.namespace not in (None, namespace) for m in managers):
        there = f"'{managers[0].namespace}'" if managers[0].namespace else "no namespace"
        told = f"the controllers are configured in {there}: leave it out, or write '{namespace}' there too"
        yield Note(told, managers[0].at)
