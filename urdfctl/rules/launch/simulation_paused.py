"""UC612."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.launch import Launch
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch_samples import (
    ARM,
    BROADCASTER,
    CLASSIC_MANIFEST,
    CLASSIC_PLUGIN,
    PUBLISHER,
    SOUND,
    launched,
)

_HOW = {"gz": "Add '-r' to gz_args", "gazebo-classic": "Set 'pause' to 'false'"}
_OF_ROS_1 = """
    <launch>
      <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
      <rosparam command="load" file="$(find arm)/controllers.yaml"/>
      <include file="$(find gazebo_ros)/launch/empty_world.launch">{}</include>
      <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm{}"/>
      <node name="spawner" pkg="controller_manager" type="spawner" args="states"/>
    </launch>
"""
_PAUSED = '<arg name="paused" value="true"/>'


def _ros1(paused: str, option: str = "") -> dict[str, str]:
    return {
        "robot.urdf": CLASSIC_PLUGIN,
        "arm.launch": _OF_ROS_1.format(paused, option),
        "controllers.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
        "package.xml": CLASSIC_MANIFEST,
        "options": "--distro=noetic",
    }


@rule(
    "UC612",
    runtime="refuses",
    because="it goes on when someone presses play",
    severity=Severity.WARNING,
    authority="gz sim --help: '-r: Run simulation on start'; ros2_control: 'Switch controller timed out after 5.000000 "
    "seconds!' (gz_ros2_control#421); ros_control controller_manager.cpp switchController(): 'wait until switch is "
    "finished', which update() does; gazebo_ros scripts/spawn_model: -unpause",
    bad=[
        launched(PUBLISHER, '\n      «<executable cmd="gz sim empty.sdf"/>»', BROADCASTER, ARM),
        launched(
            PUBLISHER,
            """
      «<include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py">»<arg name="pause" value="true"/></include>""",
            BROADCASTER,
        ),
        _ros1(f"«{_PAUSED}»"),
    ],
    good=[SOUND, _ros1(_PAUSED, " -unpause"), _ros1("")],
)
def simulation_paused(project: Project) -> Iterator[Finding]:
    """Simulation is started paused, but controllers are spawned in it.

    In a paused simulation time does not advance, and the plugin's controller manager is not updated. Nothing can be
    activated before someone presses play: the request waits. In ROS 2 the spawner gives up after five seconds.
    """
    launch = project.launch
    if launch is None or _starts_later(launch) or (launch.ros != ROS_2 and project.may_mention("unpause")):
        return
    waiting = [spawn for spawn in launch.spawns if spawn.sure and spawn.active and not spawn.option("--switch-timeout")]
    for simulation in launch.simulations:
        if simulation.paused and simulation.sure and waiting:
            how = _HOW[simulation.simulator] if launch.ros == ROS_2 else "Set 'paused' to 'false'"
            message = f"the simulation is started paused, so no controller can be activated. {how}"
            yield Finding(simulation.at, message, (Note("controllers are spawned here", waiting[0].at),))


def _starts_later(launch: Launch) -> bool:
    """Whether the program that spawns the model, or another one, goes on with the simulation."""
    words = (word.text for node in launch.nodes for word in (node.executable, *node.words))
    return any("unpause" in word for word in words)
