"""What lies beside a system and is no part of it: robots that nobody starts, old copies, tests, the other ROS."""

from __future__ import annotations

from dataclasses import replace
from random import Random

from systems.draw import MODELS, drawn_robot
from systems.idioms import settled
from systems.render.arguments import EXAMPLE
from systems.render.description import descriptions
from systems.render.leftovers import backups, calibration, parts
from systems.render.packages import package_files, runtime_packages
from systems.render.parameters import parameter_files
from systems.render.places import Places, config_folder, is_text, pick
from systems.render.workspace import Workspace
from systems.system import Controller, Joint, Robot, System

Files = dict[str, str]


def add_examples(workspace: Workspace, places: Places) -> None:
    """Add the description and the parameters that are defaults of arguments which always have another value."""
    system = workspace.system
    joint = Joint("example_joint", "revolute", ("position",))
    states = "joint_state_broadcaster" if system.generation == 2 else "joint_state_controller"
    controllers = (
        Controller(states, "broadcaster"),
        Controller("scaled_controller", "group", (joint.name,), "position"),
    )
    robot = Robot(EXAMPLE, EXAMPLE, (joint,), controllers, ())
    text, parameters = _written(replace(system, robots=(robot,), simulator="", fault=None))
    end = "urdf" if is_text(workspace.idioms) else "urdf.xacro"
    workspace.files[f"{places.description}/urdf/{EXAMPLE}.{end}"] = text
    workspace.files[f"{places.control}/{config_folder(system)}/{EXAMPLE}_controllers.yaml"] = parameters


def _written(system: System) -> tuple[str, str]:
    """The description and the parameters of a system of one robot, in plain idioms."""
    idioms = settled(system, {"source": "urdf"})
    places = Places("p", "p", "p")
    (robot,) = system.robots
    (text,) = descriptions(system, idioms, places).values()
    (parameters,) = parameter_files(system, idioms, robot, ("controllers.yaml",)).values()
    return text, parameters


def add_distractor(workspace: Workspace, places: Places) -> None:
    """Add what the switch says."""
    kind = workspace.idioms["distractor"]
    if kind == "none":
        return
    if kind == "namesakes":
        workspace.files = {**_namesakes(workspace, places), **workspace.files}
        return
    if kind == "backups":
        workspace.files = {**backups(workspace), **workspace.files}
        return
    found = {
        "parts": parts,
        "calibration": calibration,
        "unlaunched robot": _unlaunched,
        "old copy": _old_copy,
        "tests": _tests,
        "other generation": _other_generation,
        "vendored": _vendored,
        "started elsewhere": _started_elsewhere,
    }[kind](workspace.system, places)
    workspace.files = {**found, **workspace.files}


def _alone(system: System, what: str, generation: int | None = None) -> System:
    """A system of another robot, on hardware."""
    random = Random(f"{what} {system.seed}")  # noqa: S311 (nothing secret)
    used = {robot.model for robot in system.robots}
    model = random.choice([name for name in MODELS if name not in used])
    which = generation or system.generation
    distro = system.distro if which == system.generation else {1: "noetic", 2: "jazzy"}[which]
    robot = drawn_robot(random, model, which, "")
    return replace(system, generation=which, distro=distro, robots=(robot,), simulator="", moveit=False, fault=None)


def _renamed(system: System, end: str) -> System:
    """The same with other names of joints, as an older version has them, and nothing wrong."""
    (robot,) = system.robots
    names = {joint.name: f"{joint.name}{end}" for joint in robot.joints}
    joints = tuple(replace(one, name=names[one.name], parent=names.get(one.parent, "")) for one in robot.joints)
    controllers = tuple(replace(one, joints=tuple(names[name] for name in one.joints)) for one in robot.controllers)
    return replace(system, robots=(replace(robot, joints=joints, controllers=controllers),))


def _faulty(system: System) -> System:
    """The same with a joint that the robot does not have."""
    (robot,) = system.robots
    last = robot.controllers[-1]
    wrong = replace(last, joints=(*last.joints[:-1], "absent_joint"))
    return replace(system, robots=(replace(robot, controllers=(*robot.controllers[:-1], wrong)),))


def _unlaunched(system: System, _places: Places) -> Files:
    other = _alone(system, "unlaunched")
    text, parameters = _written(other)
    package = f"{other.robots[0].model}_description"
    files = {f"urdf/{other.robots[0].model}.urdf": text, "config/controllers.yaml": parameters}
    own = package_files(other, package, files, runtime_packages(other))
    return {f"{package}/{name}": content for name, content in {**files, **own}.items()}


def _old_copy(system: System, places: Places) -> Files:
    """The first robot as it was: its joints had other names."""
    robot = system.robots[0]
    plain = replace(robot, prefix="", namespace="", section="", manager="controller_manager")
    sound = tuple(
        replace(one, joints=tuple(joint.name for joint in robot.joints)[: len(one.joints)], typed=True)
        for one in plain.controllers
    )
    old = replace(system, robots=(replace(plain, controllers=sound),), simulator="", moveit=False, fault=None)
    text, parameters = _written(_renamed(old, "_v1"))
    config = config_folder(system)
    if pick(system, "old copy", ("folder", "name")) == "folder":
        names = (f"urdf/old/{robot.model}.urdf", f"{config}/old/controllers.yaml")
    else:
        names = (f"urdf/{robot.model}_old.urdf", f"{config}/controllers_backup.yaml")
    return {f"{places.description}/{names[0]}": text, f"{places.control}/{names[1]}": parameters}


def _tests(system: System, places: Places) -> Files:
    text, parameters = _written(_faulty(_alone(system, "tests")))
    folder = f"{places.control}/test/{pick(system, 'test data', ('data', 'resources', 'files'))}"
    return {f"{folder}/test_robot.urdf": text, f"{folder}/test_controllers.yaml": parameters}


def _vendored(system: System, places: Places) -> Files:
    other = _faulty(_alone(system, "vendored"))
    text, parameters = _written(other)
    folder = pick(system, "vendor", ("third_party", "vendor", "external"))
    where = f"{places.bringup}/{folder}/{other.robots[0].model}"
    return {f"{where}/urdf/{other.robots[0].model}.urdf": text, f"{where}/config/controllers.yaml": parameters}


def _other_generation(system: System, _places: Places) -> Files:
    """A package for the other generation of ROS, which somebody starts there."""
    other = _alone(system, "other generation", 3 - system.generation)
    text, parameters = _written(other)
    (robot,) = other.robots
    model, names = robot.model, " ".join(spawn.name for spawn in robot.spawned if spawn.active)
    package = f"{model}_ros{other.generation}"
    files = {f"urdf/{model}.urdf": text, "config/controllers.yaml": parameters}
    if other.generation == 1:
        files["launch/bringup.launch"] = _ROS1.format(package=package, model=model, names=names)
    else:
        files["launch/bringup.launch.xml"] = _ROS2.format(package=package, model=model, names=names)
    own = package_files(other, package, files, runtime_packages(other))
    return {f"{package}/{name}": content for name, content in {**files, **own}.items()}


def _started_elsewhere(system: System, places: Places) -> Files:
    """A launch file beside the others, for a robot like the first that launch files of other repositories start."""
    robot = system.robots[0]
    names = " ".join(spawn.name for spawn in robot.spawned if spawn.active)
    written, end = (_ROS1_ELSEWHERE, "launch") if system.generation == 1 else (_ROS2_ELSEWHERE, "launch.xml")
    return {f"{places.bringup}/launch/of_lab.{end}": written.format(package="lab_robot_bringup", names=names)}


def _namesakes(workspace: Workspace, places: Places) -> Files:
    """A package with launch files of the names of those that are started, which another one of it includes.

    That one names the package of the others, too.
    """
    package = "test_bench"
    names = [path.rpartition("/")[2] for path in workspace.starts]
    empty = {".py": _EMPTY, ".xml": "<launch/>\n", ".yaml": "launch: []\n"}
    files = {f"launch/{name}": empty[name[name.rindex(".") :]] for name in names}
    included = "".join(_INCLUDING.format(package=package, name=name) for name in names)
    files["launch/all.launch.py"] = _OUTER.format(package=places.bringup, included=included)
    own = package_files(workspace.system, package, files, ["launch"])
    return {f"{package}/{name}": content for name, content in {**files, **own}.items()}


_EMPTY = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""
_INCLUDING = """\
        IncludeLaunchDescription(os.path.join(get_package_share_directory("{package}"), "launch", "{name}")),
"""
_OUTER = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription


def generate_launch_description():
    \"\"\"Start what is tested beside {package}.\"\"\"
    return LaunchDescription([
{included}    ])
"""
_ROS1 = """\
<launch>
  <param name="robot_description" textfile="$(find {package})/urdf/{model}.urdf"/>
  <rosparam command="load" file="$(find {package})/config/controllers.yaml"/>
  <node name="robot_state_publisher" pkg="robot_state_publisher" type="robot_state_publisher"/>
  <node name="driver" pkg="{package}" type="driver_node"/>
  <node name="controller_spawner" pkg="controller_manager" type="spawner" args="{names}"/>
</launch>
"""
_ROS2 = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'cat $(find-pkg-share {package})/urdf/{model}.urdf')" type="str"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share {package})/config/controllers.yaml"/>
    <remap from="~/robot_description" to="robot_description"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="{names}"/>
</launch>
"""
_ROS1_ELSEWHERE = """\
<launch>
  <include file="$(find {package})/launch/bringup.launch"/>
  <node name="controller_spawner" pkg="controller_manager" type="spawner" args="{names}"/>
</launch>
"""
_ROS2_ELSEWHERE = """\
<launch>
  <include file="$(find-pkg-share {package})/launch/bringup.launch.py"/>
  <node pkg="controller_manager" exec="spawner" args="{names}"/>
</launch>
"""
