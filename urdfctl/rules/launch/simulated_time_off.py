"""UC649."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS1
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.launch.common import launch_of

_LAUNCH = """
    <launch>
      <include file="$(find gazebo_ros)/launch/empty_world.launch">
        <arg name="use_sim_time" value="%s"/>
      </include>
    </launch>
"""
_MANIFEST = "<package><name>arm</name><exec_depend>gazebo_ros</exec_depend></package>"


@rule(
    "UC649",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS1,
    authority='gazebo_ros empty_world.launch: <param name="/use_sim_time" value="$(arg use_sim_time)"/>; roscpp init.cpp: '
    'param::param("/use_sim_time", use_sim_time, false), which reads no number; gazebo_ros_api_plugin.cpp sets it only if '
    "nobody did",
    bad=[
        {"arm.launch": _LAUNCH % "«false»", "package.xml": _MANIFEST},
        {"arm.launch": _LAUNCH % "«1»", "package.xml": _MANIFEST},
    ],
    good=[{"arm.launch": _LAUNCH % "true", "package.xml": _MANIFEST}],
)
def simulated_time_off(project: Project) -> Iterator[Finding]:
    """Gazebo is started with use_sim_time that is not true.

    All stamps that Gazebo and its controllers publish are of the simulation, and all other nodes take the time of the
    computer: transforms are too old, and navigation and MoveIt wait. A number counts as false.
    """
    launch = launch_of(project, 1)
    for simulation in launch.simulations if launch else ():
        clock = simulation.clock
        if clock is not None and clock.known is not None and clock.text.lower() != "true" and simulation.sure:
            message = f"use_sim_time is '{clock.text}', but the robot runs in simulated time; set it to true"
            fix: Fix = replaced(clock.at, clock.text, "true")
            yield Finding(clock.at, message, fix=fix)
