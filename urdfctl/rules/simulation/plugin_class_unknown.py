"""UC505."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced


@rule(
    "UC505",
    severity=Severity.ERROR,
    runtime="drops",
    authority="gz-sim src/SystemLoader.cc: 'Failed to load system plugin: could not instantiate from library'; "
    "ros-controls/gz_ros2_control#638",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
                <gazebo>
                  <plugin filename="gz_ros2_control-system" name="«gz_ros2_control»">
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
def plugin_class_unknown(project: Project) -> Iterator[Finding]:
    """Unknown class of a gz plugin.

    In gz the name of a plugin is not free, as it was in Gazebo Classic: it must be a class that the library registers.
    Otherwise the plugin is not loaded, and nothing of ros2_control runs.
    """
    for sim_plugin in loaded_plugins(project):
        name = re.sub(r"::v[0-9]+::", "::", (sim_plugin.plugin.name or "").strip())
        names = {name: None for known in sim_plugin.known for name in (*known.names, *known.old_names)}
        if not name or not names or name in names or not is_known(name):
            continue
        expected = next(iter(names))
        at = sim_plugin.plugin.at["name"]
        message = f"library '{sim_plugin.filename}' has no class '{sim_plugin.plugin.name}'; use '{expected}'"
        fix = replaced(at, sim_plugin.plugin.name or "", expected, safe=len(names) == 1)
        yield Finding(at, message, fix=fix)
