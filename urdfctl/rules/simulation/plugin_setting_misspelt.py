"""UC511."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import namespace_of
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import renamed
from urdfctl.rules.simulation.common import Unread, unread_settings


@rule(
    "UC511",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="gazebo_ros_pkgs: in ROS 2 the settings of plugins are written_like_this, in ROS 1 writtenLikeThis; sdformat "
    "Element::HasElement compares names exactly, and a plugin asks only for the names that it knows",
    options=["--distro=galactic"],
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def plugin_setting_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt plugin setting, or a setting of the other ROS version.

    The plugin looks up its settings by name and uses the default if it finds none. The value is lost without a message.
    """
    for unread in unread_settings(project):
        if unread.meant is None:
            continue
        shown = unread.shown
        fix = Fix(f"write {shown}")
        if unread.meant in unread.sim_plugin.children and "/" not in unread.name + unread.meant:
            fix = Fix(f"write {shown}", renamed(unread.tag, unread.meant), safe=unread.same)
        message = f"'{unread.sim_plugin.filename}' has no setting <{unread.name.removeprefix('ros/')}>; use {shown}"
        severity = Severity.INFO if unread.harmless else None
        yield Finding(unread.tag.at, message, tuple(_notes(project, unread)), fix, severity)


def _notes(project: Project, unread: Unread) -> Iterator[Note]:
    """A note if the controllers are not configured in the given namespace."""
    managers = project.controllers.managers if project.controllers else ()
    namespace = namespace_of(unread.tag.text)
    if (
        unread.meant == "ros/namespace"
        and managers
        and all(manager.namespace not in (None, namespace) for manager in managers)
    ):
        where = f"in namespace '{managers[0].namespace}'" if managers[0].namespace else "without a namespace"
        text = f"the controllers are configured {where}; remove this setting, or use '{namespace}' there too"
        yield Note(text, managers[0].at)
