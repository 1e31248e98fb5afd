"""UC534."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.control.hardware.gazebo_plugins import IN_GZ
from urdfctl.control.hardware.simulator_plugins import of_sensors, written_plugins
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule

_HOST = """
    <ros2_control name="arm" type="system">
      <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>/opt/arm/controllers.yaml</parameters>
      </plugin>
      %s
    </gazebo>
"""
_POSE = '<plugin name="pose" filename="%s"><bodyName>fore</bodyName><updateRate>50</updateRate></plugin>'


@rule(
    "UC534",
    severity=Severity.WARNING,
    runtime="drops",
    because="the robot moves without it, unless it drives the wheels",
    distros=ROS2,
    authority="gz-sim src/SystemLoader.cc: 'Failed to load system plugin [libgazebo_ros_p3d.so] : Could not find shared "
    "library': the plugins of gazebo_ros_pkgs are for Gazebo Classic's gazebo::ModelPlugin",
    options=["--distro=humble"],
    bad=[{"robot.urdf": _HOST % (_POSE % "«libgazebo_ros_p3d.so»")}],
    good=[{"robot.urdf": _HOST % ""}],
)
def plugin_of_other_simulator(project: Project) -> Iterator[Finding]:
    """Plugin of Gazebo Classic in a robot for gz.

    gz says that it cannot load the plugin, and goes on without: no sensor publishes, no wheel is driven. What settings
    such a plugin has does not matter. If the robot has the control plugins of both simulators, it is for both.
    """
    plugins = written_plugins(project)
    hosts = {plugin.simulator for plugin in plugins if plugin.hosts_control}
    if project.simulator != "gz" or "gazebo-classic" in hosts or set(project.distros) <= set(since("jazzy")):
        return  # since jazzy, UC701 reports the plugin
    classic = [plugin for plugin in (*plugins, *of_sensors(project)) if plugin.simulator == "gazebo-classic"]
    libraries = [plugin.library for plugin in classic]
    for number, plugin in enumerate(classic):
        if plugin.library in libraries[:number]:
            continue
        more = libraries.count(plugin.library) - 1
        instead = IN_GZ.get(plugin.library)
        message = f"plugin '{plugin.filename}' is for Gazebo Classic, but the robot runs in gz, which does not load it"
        notes = (Note(f"{more} more in this robot"),) if more else ()
        yield Finding(plugin.plugin.at["filename"], message, notes, Fix(f"in gz use {instead}") if instead else None)
