"""UC513."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, loaded_plugins
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there
from urdfctl.rules.simulation.common import is_written_empty


@rule(
    "UC513",
    runtime="refuses",
    because="the plugin of Gazebo Classic goes on",
    severity=Severity.WARNING,
    authority="gz_ros2_control src/gz_ros2_control_plugin.cpp: 'Gazebo ros2 control found an empty parameters file. Failed to "
    "initialize.'; gazebo_ros2_control: 'No parameter file provided. Configuration might be wrong'",
    options=["--distro=jazzy"],
    bad=[
        {
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
def plugin_setting_missing(project: Project) -> Iterator[Finding]:
    """Missing plugin setting.

    The plugin of gz for ros2_control exits at once if no `<parameters>` names a file. The one of Gazebo Classic goes on
    without controllers. A drive without its wheel joints does not start.
    """
    for sim_plugin in loaded_plugins(project):
        if not sim_plugin.known or not is_all_there(project, sim_plugin.plugin.tag):
            continue
        for name in _required(sim_plugin):
            given = sim_plugin.setting(name)
            if given is not None and not is_written_empty(given):
                continue
            is_fatal = sim_plugin.drives or (sim_plugin.hosts_control and sim_plugin.simulator == "gz")
            fault = f"an empty <{name}>" if given else f"no <{name}>"
            message = f"'{sim_plugin.filename}' has {fault} and does not work without it"
            if name == "parameters":
                message = f"'{sim_plugin.filename}' has {fault}, which must name the controller file"
            at = given.at if given else sim_plugin.plugin.at
            yield Finding(at, message, severity=Severity.ERROR if is_fatal else None)


def _required(sim_plugin: LoadedPlugin) -> list[str]:
    """The settings that the plugin requires in all of the project's distros."""
    first = sim_plugin.known[0].children
    return [
        name
        for name in first
        if all(name in known.children and known.children[name].required for known in sim_plugin.known)
    ]
