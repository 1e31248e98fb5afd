"""UC706."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.hardware.simulator_plugins import IN_GAZEBO, components, control_plugins, simulator_of
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.migration.common import lacking


@rule(
    "UC706",
    severity=Severity.INFO,
    runtime="works",
    distros=ROS2,
    authority="gazebo_ros2_control README: 'gazebo_ros2_control won't be released for Jazzy and Rolling anymore'",
    options=["--distro=iron"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>«<plugin>»gazebo_ros2_control/GazeboSystem</plugin></hardware>
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
def hardware_gone_soon(project: Project) -> Iterator[Finding]:
    """Simulated hardware is missing in a later distro.

    The rule checks the distros up to the next one with long-term support. If the robot also loads the simulator's
    plugin, only the plugin is reported (UC705).
    """
    catalog = project.catalog
    if control_plugins(project):
        return
    for control in components(project):
        name = control.plugin or ""
        if not is_known(name) or simulator_of(project, control) not in (*IN_GAZEBO, "mock"):
            continue
        there = {distro: hardware for distro in ROS2 if (hardware := catalog.hardware(name, distro))}
        gone = lacking(project, tuple(there))
        if gone is None or there[project.distro or gone].deprecated:
            continue
        right = catalog.hardware_replacement(name, gone)
        message = f"hardware plugin '{name}' exists in {project.distro} but not in {gone}"
        fix = Fix(f"in {gone} use '{right}'") if right else None
        yield Finding(control.hardware[-1].plugins[0].at, message, fix=fix)
