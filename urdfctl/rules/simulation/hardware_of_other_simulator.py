"""UC506."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.control.hardware.simulator_plugins import (
    IN_GAZEBO,
    components,
    simulator_of,
    started_simulator,
    written_plugins,
)
from urdfctl.rule import Finding, Fix, Note, Project, Severity, rule


@rule(
    "UC506",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="gz_ros2_control src/gz_ros2_control_plugin.cpp and gazebo_ros2_control src/gazebo_ros2_control_plugin.cpp:"
    " 'The plugin failed to load for some reason. Error: According to the loaded plugin descriptions the class "
    "gazebo_ros2_control/GazeboSystem ... does not exist'",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gazebo_ros2_control/GazeboSystem</plugin></hardware>
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
def hardware_of_other_simulator(project: Project) -> Iterator[Finding]:
    """Hardware and control plugin are for different simulators.

    Gazebo Classic's plugin loads `gazebo_ros2_control/GazeboSystem` and similar, and gz's plugin loads
    `gz_ros2_control/GazeboSimSystem`. Neither finds the other's hardware, and the joints have no interfaces. If the
    simulator is known, the finding is at the one of them that does not run in it.
    """
    hosts = [sim_plugin for sim_plugin in written_plugins(project) if sim_plugin.hosts_control]
    without_classic = set(project.distros) <= set(since("jazzy"))
    for control in components(project):
        simulator = simulator_of(project, control)
        if not hosts or simulator not in IN_GAZEBO or any(sim_plugin.simulator == simulator for sim_plugin in hosts):
            continue
        host = hosts[0]
        if simulator == "gz" and without_classic:
            continue  # UC701 reports the plugin
        default = host.any.default_hardware if host.any else None
        if started_simulator(project) == simulator:
            message = f"plugin '{host.filename}' is for {IN_GAZEBO.get(host.simulator or '', 'another simulator')}, "
            message += f"but the robot runs in {IN_GAZEBO[simulator]}; no plugin loads '{control.plugin}'"
            yield Finding(host.plugin.at["filename"], message)
            continue
        message = f"'{control.plugin}' is for {IN_GAZEBO[simulator]}, but plugin '{host.filename}' is for "
        message += IN_GAZEBO.get(host.simulator or "", "another simulator")
        notes = (Note("the plugin is loaded here", host.plugin.at),)
        at = control.hardware[-1].plugins[0].at
        yield Finding(at, message, notes, Fix(f"write <plugin>{default}</plugin>") if default else None)
