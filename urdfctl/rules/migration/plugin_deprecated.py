"""UC702."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.migration.common import severity_of_old
from urdfctl.rules.simulation.common import Loaded, loaded

_OF_IGNITION = "ignition-gazebo"
_OF_GZ = since("jazzy")
"""The distros whose simulator is no longer called Ignition."""


@rule(
    "UC702",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="gz_ros2_control src/gz_system.cpp: 'The ign_ros2_control plugin got renamed to gz_ros2_control.'; gz-sim "
    "src/SystemLoader.cc: 'Trying to load deprecated plugin [ignition-gazebo-diff-drive-system]. Using "
    "[gz-sim-diff-drive-system] instead.'",
    options=["--distro=jazzy"],
    bad={
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
def plugin_deprecated(project: Project) -> Iterator[Finding]:
    """A plugin of the simulator bears a name of the time when gz was called Ignition.

    It is still loaded, with a warning; later distros do not have it. Where no distro is named, this is told where all
    that are maintained have the new name.
    """
    for one in loaded(project):
        fixes = [fix for fix in (_file(project, one), _class(project, one)) if fix]
        if not fixes:
            continue
        title = " and ".join(f'{attribute}="{right}"' for attribute, _, right, _ in fixes)
        edits = tuple(
            Edit(one.plugin.at[attribute].span, right)
            for attribute, old, right, _ in fixes
            if one.plugin.at[attribute].span.text == old
        )
        attribute, old, _, severity = fixes[0]
        message = f"'{old}' is a name of the time when gz was Ignition; by now it is {title}"
        fix = Fix(f"write {title}", edits if len(edits) == len(fixes) else ())
        yield Finding(one.plugin.at[attribute], message, fix=fix, severity=severity)


Renamed = tuple[str, str, str, Severity]
"""An attribute, what it says, what it should say, and how much it matters."""


def _file(project: Project, one: Loaded) -> Renamed | None:
    old = one.plugin.filename or ""
    ignition = _OF_IGNITION in old
    by_distro = {distro: project.catalog.simulator_plugin(old, distro) for distro in ROS2}
    old_in = [distro for distro, plugin in by_distro.items() if plugin is None or plugin.deprecated]
    severity = severity_of_old(project, _OF_GZ if ignition else old_in) if one.known else None
    right = old.replace(_OF_IGNITION, "gz-sim") if ignition else _successor(project, one)
    return ("filename", old, right, severity) if severity and right else None


def _successor(project: Project, one: Loaded) -> str | None:
    """The file of the plugin that took another's place."""
    wanted = one.known[-1].replacement if one.known else None
    newest = project.catalog.simulator_plugins("rolling") if wanted else ()
    return next((plugin.filenames[0] for plugin in newest if plugin.id == wanted), None)


def _class(project: Project, one: Loaded) -> Renamed | None:
    old = one.plugin.name or ""
    renamed = {old: plugin.names[0] for plugin in one.known for old in plugin.old_names}
    renamed |= {plugin.names[0]: plugin.names[-1] for plugin in one.known if plugin.deprecated}
    right = renamed.get(old)
    severity = severity_of_old(project, _OF_GZ if old.startswith("ignition::") else since("humble"))
    return ("name", old, right, severity) if severity and right else None
