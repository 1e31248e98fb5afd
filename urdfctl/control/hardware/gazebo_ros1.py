"""Gazebo's default hardware simulation of ROS 1: whether it runs a robot, and which interfaces it knows."""

from __future__ import annotations

from itertools import chain

from urdfctl.control.hosts import hosts_no_manager
from urdfctl.diagnostic import Severity
from urdfctl.model.project import Project
from urdfctl.model.robot import Plugin

GAZEBO_INTERFACES = ("EffortJointInterface", "PositionJointInterface", "VelocityJointInterface")
"""Interfaces that gazebo_ros_control's DefaultRobotHWSim knows (default_robot_hw_sim.cpp)."""
_DEFAULT_SIMULATION = ("", "gazebo_ros_control/DefaultRobotHWSim")

_CONTROL_PLUGIN = "libgazebo_ros_control.so"


def control_plugins(project: Project) -> tuple[Plugin, ...]:
    """Return the gazebo_ros_control plugins that the robot loads."""
    plugins = project.robot.plugins if project.robot else ()
    return tuple(plugin for plugin in plugins if (plugin.filename or "").strip().rsplit("/")[-1] == _CONTROL_PLUGIN)


def in_gazebo(project: Project) -> Severity | None:
    """Return the severity of what Gazebo's default hardware simulation rejects; None if it does not run the robot.

    An error if it is known to run the robot: the user names Gazebo Classic, or names nothing and the robot loads the
    plugin, unless a launch file starts the robot without Gazebo. Otherwise a warning; nothing if the robot that such a
    launch file starts does not load the plugin either.
    """
    plugins = control_plugins(project)
    default = [plugin for plugin in plugins if _simulation(plugin) in _DEFAULT_SIMULATION]
    if project.named_simulator not in (None, "gazebo-classic") or (plugins and not default):
        return None
    is_elsewhere = not project.named_simulator and is_started_without_gazebo(project)
    if is_elsewhere and not plugins:
        return None
    sure = project.named_simulator or (default and not is_elsewhere)
    return Severity.ERROR if sure else Severity.WARNING


def is_started_without_gazebo(project: Project) -> bool:
    """Return whether a launch file starts the robot with other hardware: the plugin of Gazebo is in the description all
    the same."""
    launch = project.launch
    if launch is None or not launch.complete or launch.simulations:
        return False
    nodes = (*launch.nodes, *chain(*launch.beside))
    return bool(nodes) and not any("gazebo" in node.package.text for node in nodes)


def may_be_driven(project: Project) -> bool:
    """Return whether a launch file of ROS 1 starts no Gazebo, but what may be a driver: it names its joints itself, and
    runs the controllers."""
    if project.launch is None or project.ros != 1 or not is_started_without_gazebo(project):
        return False
    return not all(map(hosts_no_manager, project.launch.nodes))


def has_own_simulation(project: Project) -> bool:
    """Return whether a class of another package simulates the robot's hardware, with rules of its own."""
    kinds = [_simulation(plugin) for plugin in control_plugins(project)]
    return bool(kinds) and all(kind and not kind.startswith("gazebo_ros_control") for kind in kinds)


def _simulation(plugin: Plugin) -> str:
    setting = plugin.setting("robotSimType")
    return setting.text.strip() if setting else ""
