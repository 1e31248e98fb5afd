"""UC508."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import (
    IN_GAZEBO,
    components,
    simulator_of,
    started_simulator,
    written_plugins,
)
from urdfctl.control.model_spawners import spawns_unread_model
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.insertions import appended_to_robot, controllers_path, host_element

_DOUBT = "the plugin may be in a file that is not linted"


@rule(
    "UC508",
    runtime="refuses",
    because=_DOUBT,
    severity=Severity.WARNING,
    distros=ROS2,
    whole_robot=True,
    in_library=False,
    authority="gz_ros2_control and gazebo_ros2_control, Add the plugin: it 'parses the ros2_control tags and loads the "
    "appropriate hardware interfaces and controller manager'",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gz_ros2_control/GazeboSimSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
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
def control_plugin_missing(project: Project) -> Iterator[Finding]:
    """Hardware for Gazebo without the plugin that loads it.

    The controller manager of a simulated robot runs in a plugin of Gazebo, which loads the hardware. Without the
    plugin, spawners wait for a controller manager that never starts. This is an error if the simulator is named, or if
    the launch file starts it.
    """
    robot = whole_robot_in(project)
    if (
        robot is None
        or spawns_unread_model(project.launch)
        or any(
            sim_plugin.hosts_control or sim_plugin.any is None
            for sim_plugin in written_plugins(project)
            if sim_plugin.filename
        )
    ):
        return
    for control in components(project):
        simulator = simulator_of(project, control)
        if simulator not in IN_GAZEBO:
            continue
        last = project.distros[-1] if project.distro else "iron" if simulator == "gazebo-classic" else "rolling"
        hosts = [plugin for plugin in project.catalog.simulator_plugins(last) if plugin.hosts_control]
        host = next((plugin for plugin in hosts if plugin.simulator == simulator), None)
        message = f"'{control.plugin}' runs in {IN_GAZEBO[simulator]}, but no <plugin> of the robot loads it there"
        fix = None
        if host:
            name = host.names[0] if host.names else "gazebo_ros2_control"
            path = controllers_path(project)
            element = f'<plugin filename="{host.filenames[0]}" name="{name}">'
            edits = appended_to_robot(robot, host_element(host.filenames[0], name, path)) if path else ()
            fix = Fix(
                f"add <gazebo>{element}<parameters>{path or '...'}</parameters></plugin></gazebo>", edits, doubt=_DOUBT
            )
        severity = Severity.ERROR if started_simulator(project) == simulator else None
        way = f"to write it: urdfctl gen-gazebo --simulator {simulator} --into {shlex.quote(robot.at.source.path)}"
        yield Finding(control.hardware[-1].plugins[0].at, message, notes=(Note(way),), fix=fix, severity=severity)
        return
