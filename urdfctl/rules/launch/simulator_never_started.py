"""UC622."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.model_spawners import model_spawners
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.launch.steps import STARTS_SIMULATOR

_MODEL = '<node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>'
_ROS_1 = """
            <launch>
              <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
              %s
            </launch>
"""
_CREATE = '<node pkg="ros_gz_sim" exec="create" args="-file $(find-pkg-share arm)/robot.urdf -name arm"/>'
_MANIFEST = "<package><name>arm</name><exec_depend>{0}</exec_depend></package>"
_SERVED = '<launch>%s<include file="$(find-pkg-share ros_gz_sim)/launch/gz_server.launch.py"/></launch>'


def _of_ros1(*nodes: str) -> dict[str, str]:
    return {"robot.urdf": "", "arm.launch": _ROS_1 % "".join(nodes), "package.xml": _MANIFEST.format("gazebo_ros")}


def _of_ros2(launch: str) -> dict[str, str]:
    return {"robot.urdf": "", "arm.launch.xml": launch, "package.xml": _MANIFEST.format("ros_gz_sim")}


@rule(
    "UC622",
    severity=Severity.WARNING,
    runtime="refuses",
    because="somebody may start it by hand",
    authority="ros_gz_sim create.cpp: 'Requesting list of world names.', until a world answers; gazebo_ros spawn_entity.py: "
    "'Service /spawn_entity unavailable. Was Gazebo started with GazeboRosFactory?'; gazebo_interface.py waits for the service",
    bad=[
        _of_ros1(f"«{_MODEL}»"),
        _of_ros2(f"<launch>«{_CREATE}»</launch>"),
    ],
    good=[
        _of_ros1(_MODEL, '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'),
        _of_ros1(_MODEL, '<node name="gazebo" pkg="gazebo_ros" type="gzserver"/>'),
        _of_ros1(
            _MODEL,
            '<arg name="sim" default="false"/>',
            '<include file="$(find gazebo_ros)/launch/empty_world.launch" if="$(arg sim)"/>',
        ),
        {**_of_ros1(_MODEL), "README.md": "roslaunch gazebo_ros empty_world.launch\n"},
        _of_ros2(_SERVED % _CREATE),
        {**_of_ros2(f"<launch>{_CREATE}</launch>"), "start.sh": "gz sim -r empty.sdf\n"},
    ],
)
def simulator_never_started(project: Project) -> Iterator[Finding]:
    """Model is spawned into a simulator that nothing starts.

    The program that spawns the model waits for the simulator, and no controller manager starts. No launch file, script
    or README of the workspace starts one.
    """
    launch = project.launch
    if launch is None or not launch.complete or launch.simulations:
        return
    spawner = next((node for node in model_spawners(launch) if node.sure), None)
    if spawner is None or any(_may_simulate(node.package.text) for node in launch.nodes):
        return
    if project.may_mention(STARTS_SIMULATOR):
        return
    simulator = "gz" if spawner.executable.text == "create" else "Gazebo"
    message = f"'{spawner.executable.text}' spawns a model, but nothing here starts {simulator}"
    included = "gz_sim.launch.py of ros_gz_sim" if simulator == "gz" else "gazebo.launch.py of gazebo_ros"
    if launch.ros == 1:
        included = "empty_world.launch of gazebo_ros"
    yield Finding(spawner.at, message, (Note(f"include {included}, before the model is spawned"),))


def _may_simulate(package: str) -> bool:
    """Whether a package that is no known one may start a simulator."""
    known = ("gazebo_ros", "ros_gz", "ros_gz_sim", "ros_gz_bridge", "ros_gz_image", "ros_ign_gazebo", "ros_ign_bridge")
    return package not in known and any(word in package for word in ("gazebo", "gz", "ign", "sim"))
