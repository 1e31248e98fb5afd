"""UC505."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.simulation.common import loaded


@rule(
    "UC505",
    severity=Severity.ERROR,
    authority="gz-sim src/SystemLoader.cc: 'Failed to load system plugin: could not instantiate from library'; "
    "ros-controls/gz_ros2_control#638",
    bad={
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
def plugin_class_unknown(project: Project) -> Iterator[Finding]:
    """A plugin of gz has a name that is no class of its library.

    In gz the name is not free, as it was in Gazebo Classic: it must be that of a class that the library registers.
    Otherwise the plugin is not loaded, and of ros2_control nothing runs.
    """
    for one in loaded(project):
        name = re.sub(r"::v[0-9]+::", "::", (one.plugin.name or "").strip())
        names = {each: None for known in one.known for each in (*known.names, *known.old_names)}
        if not name or not names or name in names or not is_known(name):
            continue
        right = next(iter(names))
        at = one.plugin.at["name"]
        message = f"'{one.plugin.name}' is no class in the library '{one.filename}'; its name must be '{right}'"
        fix = replaced(at, one.plugin.name or "", right, safe=len(names) == 1)
        yield Finding(at, message, fix=fix)
