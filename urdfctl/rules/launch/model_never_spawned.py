"""UC623."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.hardware.simulator_plugins import control_plugins
from urdfctl.control.model_spawners import model_spawners
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import whole_robot_in
from urdfctl.rules.launch.common import ROS_2
from urdfctl.rules.launch.steps import SPAWNS_MODEL, started_apart
from urdfctl.rules.launch_samples import CLASSIC_MANIFEST, CLASSIC_PLUGIN

_LAUNCH = """
            <launch>
              %s<include file="$(find gazebo_ros)/launch/empty_world.launch"/>%s
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              <node name="spawner" pkg="controller_manager" type="spawner" args="states"/>
              <rosparam command="load" file="$(find arm)/controllers.yaml"/>
              %s
            </launch>
"""
_SPAWN = '<node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>'


def _files(mark: tuple[str, str], *nodes: str) -> dict[str, str]:
    return {
        "robot.urdf": CLASSIC_PLUGIN,
        "arm.launch": _LAUNCH % (*mark, "".join(nodes)),
        "controllers.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
        "package.xml": CLASSIC_MANIFEST,
    }


@rule(
    "UC623",
    severity=Severity.WARNING,
    runtime="refuses",
    because="the world may contain the model, or somebody may spawn it by hand",
    whole_robot=True,
    in_library=False,
    options=["--distro=noetic"],
    authority="gazebo_ros_control gazebo_ros_control_plugin.cpp Load(), gz_ros2_control Configure(): the plugin of a model is "
    "loaded with the model; robot_description alone spawns nothing",
    bad=[_files(("«", "»"))],
    good=[
        _files(("", ""), _SPAWN),
        _files(("", ""), f'<arg name="own" default="true"/><group unless="$(arg own)">{_SPAWN}</group>'),
        {**_files(("", "")), "README.md": "rosrun gazebo_ros spawn_model -urdf -param robot_description -model arm\n"},
        {
            **_files(("", "")),
            "arm.world": '<sdf><world name="w"><include><uri>model://arm</uri></include></world></sdf>',
        },
    ],
)
def model_never_spawned(project: Project) -> Iterator[Finding]:
    """Simulator is started, but the robot is never spawned into it.

    The controller manager of a simulated robot runs in a plugin of its model. Without the model there is no manager, and
    each spawner of controllers waits for it. No launch file, script, world or README of the workspace spawns the robot.
    """
    launch, robot = project.launch, whole_robot_in(project)
    if launch is None or robot is None or not launch.complete or not launch.descriptions or not launch.spawns:
        return
    simulation = next((one for one in launch.simulations if one.sure), None)
    plugins = [plugin for plugin in control_plugins(project) if simulation and plugin.simulator == simulation.simulator]
    if simulation is None or not plugins or model_spawners(launch) or any(map(_may_spawn, _programs(project))):
        return
    worlds = rf"ros2?_control|model://{robot.name}|name=.{robot.name}\b"
    if project.may_mention(SPAWNS_MODEL, started_apart(launch)) or project.may_mention(rf"(?s)<world.*(?:{worlds})"):
        return
    program = "create" if simulation.simulator == "gz" else "spawn_entity.py" if launch.ros == ROS_2 else "spawn_model"
    message = f"the simulator is started, but nothing here spawns the robot in it; start '{program}'"
    yield Finding(simulation.at, message, (Note("this plugin runs the controllers", plugins[0].plugin.at),))


def _programs(project: Project) -> Iterator[str]:
    for node in project.launch.nodes if project.launch else ():
        yield f"{node.package.text}/{node.executable.text}"


def _may_spawn(program: str) -> bool:
    """Whether a program may spawn models, by its name."""
    known = ("ros_gz_bridge/", "ros_gz_image/", "ros_ign_bridge/", "gazebo_ros/g", "ros_gz_sim/g")
    return not program.startswith(known) and any(word in program for word in ("gazebo", "gz", "ign_", "spawn_", "sim"))
