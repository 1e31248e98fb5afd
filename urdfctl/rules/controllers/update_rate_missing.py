"""UC426."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.catalog.hardware import SimulatorPlugin
from urdfctl.control.hardware.simulator_plugins import LoadedPlugin, control_plugins, sure_simulator
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import severity_where

_HOSTS = (
    ("humble", "libgazebo_ros2_control.so", "control", "gazebo_ros2_control/GazeboSystem"),
    (
        "humble",
        "ign_ros2_control-system",
        "ign_ros2_control::IgnitionROS2ControlPlugin",
        "ign_ros2_control/IgnitionSystem",
    ),
    (
        "iron",
        "gz_ros2_control-system",
        "gz_ros2_control::GazeboSimROS2ControlPlugin",
        "gz_ros2_control/GazeboSimSystem",
    ),
)


@rule(
    "UC426",
    severity=Severity.INFO,
    runtime="works",
    distros=until("iron"),
    authority="gazebo_ros2_control gazebo_ros2_control_plugin.cpp Load(): 'controller manager doesn't have an update_rate "
    "parameter'; ros2_control controller_manager/src/controller_manager.cpp: ''update_rate' parameter not set, using "
    "default value.'",
    options=["--distro=humble"],
    bad=[
        {
            "controllers.yaml": """
                «controller_manager»:
                  ros__parameters:
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
        *(
            {
                "options": f"--distro={distro}",
                "robot.urdf": f"""
                    <ros2_control name="arm" type="system">
                      <hardware><plugin>{hardware}</plugin></hardware>
                      <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                    </ros2_control>
                    <gazebo><plugin name="{name}" filename="{library}"><parameters>controllers.yaml</parameters></plugin></gazebo>
                """,
                "controllers.yaml": """
                    «controller_manager»:
                      ros__parameters:
                        joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
                """,
            }
            for distro, library, name, hardware in _HOSTS
        ),
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
    ],
)
def update_rate_missing(project: Project) -> Iterator[Finding]:
    """Controller manager without an update rate.

    It runs at 100 Hz, and up to iron prints a message about it. From jazzy on, 100 Hz is the documented default. But up
    to iron the plugins of Gazebo give up without it: the manager answers, and no controller ever moves a joint.
    """
    controllers = controllers_in(project)
    if not controllers.complete:
        return
    hosts = _demanding(project)
    for manager in controllers.managers:
        if not manager.own or "update_rate" in manager.parameters:
            continue
        if not hosts:
            yield Finding(manager.at, f"'{manager.name}' has no 'update_rate'; it runs at 100 Hz")
            continue
        name = hosts[0].filename
        message = f"'{manager.name}' has no 'update_rate'; without it plugin '{name}' gives up, and nothing moves"
        certain = sure_simulator(project) and not (project.launch and project.launch.runs_without_simulator)
        yield Finding(
            manager.at,
            message,
            (Note("the plugin is here", hosts[0].plugin.at),),
            severity=severity_where(project, _refusing(project, hosts)) if certain else Severity.WARNING,
        )


def _demanding(project: Project) -> tuple[LoadedPlugin, ...]:
    """The plugins that give up without an update rate in some distro."""
    return tuple(plugin for plugin in control_plugins(project) if any(map(_needs_rate, plugin.known)))


def _refusing(project: Project, hosts: tuple[LoadedPlugin, ...]) -> Iterator[str]:
    """The distros in which one of the plugins gives up."""
    for distro in project.distros:
        entries = (project.catalog.simulator_plugin(host.filename, distro) for host in hosts)
        if any(entry and _needs_rate(entry) for entry in entries):
            yield distro


def _needs_rate(plugin: SimulatorPlugin) -> bool:
    load = plugin.when("load")
    return load is not None and "update_rate" in load.needs
