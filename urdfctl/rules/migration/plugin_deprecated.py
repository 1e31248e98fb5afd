"""UC702."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, loaded_plugins
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.migration.common import is_chosen, severity_of_old

_OF_IGNITION = "ignition-gazebo"
_OF_GZ = since("jazzy")
"""The distros whose simulator is no longer called Ignition."""


@rule(
    "UC702",
    runtime="warns",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="gz_ros2_control src/gz_system.cpp: 'The ign_ros2_control plugin got renamed to gz_ros2_control.'; gz-sim "
    "src/SystemLoader.cc: 'Trying to load deprecated plugin [ignition-gazebo-diff-drive-system]. Using "
    "[gz-sim-diff-drive-system] instead.'",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="«ign_ros2_control-system»" name="ign_ros2_control::IgnitionROS2ControlPlugin">
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
def plugin_deprecated(project: Project) -> Iterator[Finding]:
    """Simulator plugin has an old name from Ignition.

    gz was called Ignition before. The simulator still loads the plugin, with a warning, but later distros do not have
    it. If the distro is unknown, the rule reports a name only if all maintained distros have the new one. A file in
    which conditions choose between both names is right.
    """
    for loaded_plugin in loaded_plugins(project):
        fixes = [fix for fix in (_file(project, loaded_plugin), _class(project, loaded_plugin)) if fix]
        if not fixes:
            continue
        plugin = loaded_plugin.plugin
        if all(is_chosen(plugin.at[attribute], right) for attribute, _, right, _ in fixes):
            continue
        title = " and ".join(f'{attribute}="{right}"' for attribute, _, right, _ in fixes)
        edits = tuple(
            Edit(plugin.at[attribute].span, right)
            for attribute, old, right, _ in fixes
            if plugin.at[attribute].span.text == old
        )
        attribute, old, _, severity = fixes[0]
        message = f"'{old}' is an old name from Ignition; use {title}"
        fix = Fix(f"write {title}", edits if len(edits) == len(fixes) else ())
        yield Finding(plugin.at[attribute], message, fix=fix, severity=severity)


Renamed = tuple[str, str, str, Severity]
"""An attribute, its value, the right value, and the severity."""


def _file(project: Project, plugin: LoadedPlugin) -> Renamed | None:
    old = plugin.plugin.filename or ""
    ignition = _OF_IGNITION in old
    by_distro = {distro: project.catalog.simulator_plugin(old, distro) for distro in ROS2}
    old_in = [distro for distro, entry in by_distro.items() if entry is None or entry.deprecated]
    severity = severity_of_old(project, _OF_GZ if ignition else old_in) if plugin.known else None
    right = old.replace(_OF_IGNITION, "gz-sim") if ignition else _successor(project, plugin)
    return ("filename", old, right, severity) if severity and right else None


def _successor(project: Project, plugin: LoadedPlugin) -> str | None:
    """The file of the plugin that replaced this one."""
    wanted = plugin.known[-1].replacement if plugin.known else None
    newest = project.catalog.simulator_plugins("rolling") if wanted else ()
    return next((entry.filenames[0] for entry in newest if entry.id == wanted), None)


def _class(project: Project, plugin: LoadedPlugin) -> Renamed | None:
    old = plugin.plugin.name or ""
    renamed = {former: entry.names[0] for entry in plugin.known for former in entry.old_names}
    renamed |= {entry.names[0]: entry.names[-1] for entry in plugin.known if entry.deprecated}
    right = renamed.get(old)
    severity = severity_of_old(project, _OF_GZ if old.startswith("ignition::") else since("humble"))
    return ("name", old, right, severity) if severity and right else None
