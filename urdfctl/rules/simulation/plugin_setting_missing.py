"""UC513."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there
from urdfctl.rules.simulation.common import Loaded, is_written_empty, loaded


@rule(
    "UC513",
    severity=Severity.WARNING,
    authority="gz_ros2_control src/gz_ros2_control_plugin.cpp: 'Gazebo ros2 control found an empty parameters file. Failed to "
    "initialize.'; gazebo_ros2_control: 'No parameter file provided. Configuration might be wrong'",
    options=["--distro=jazzy"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
            <gazebo>
              «<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/>»
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
def plugin_setting_missing(project: Project) -> Iterator[Finding]:
    """A plugin lacks a setting that it cannot do without.

    gz's plugin for ros2_control ends at once where no `<parameters>` name a file; that of Gazebo Classic goes on
    without controllers. A drive without its wheels' joints does not start.
    """
    for one in loaded(project):
        if not one.known or not is_all_there(project, one.plugin.tag):
            continue
        for name in _required(one):
            given = one.setting(name)
            if given is not None and not is_written_empty(given):
                continue
            refused = one.drives or (one.hosts_control and one.simulator == "gz")
            told = f"an empty <{name}>" if given else f"no <{name}>"
            message = f"'{one.filename}' has {told}, without which it does not work"
            if name == "parameters":
                message = f"'{one.filename}' has {told}, which names the file with the controllers"
            at = given.at if given else one.plugin.at
            yield Finding(at, message, severity=Severity.ERROR if refused else None)


def _required(one: Loaded) -> list[str]:
    """What every distro wants that the project may be for."""
    first = one.known[0].children
    return [name for name in first if all(name in each.children and each.children[name].required for each in one.known)]
