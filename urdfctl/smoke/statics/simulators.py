"""Which simulator moves the joints of a robot, according to its description."""

from __future__ import annotations

from urdfctl.catalog.catalog import Catalog
from urdfctl.catalog.distros import generation
from urdfctl.control.hardware.gazebo_ros1 import in_gazebo
from urdfctl.control.hardware.simulator_plugins import loaded_plugins
from urdfctl.diagnostic import Severity
from urdfctl.model.project import Project
from urdfctl.model.robot import Ros2Control
from urdfctl.names import enumerated

GAZEBO_ROS1 = "gazebo_ros_control"
_WORLDS = ("gz", "gazebo-classic")
"""The simulators in which a robot stands on the ground and falls."""


def simulator_of(control: Ros2Control, catalog: Catalog, distro: str) -> str:
    """Return the simulator whose hardware a component loads: one of the catalogue, or empty."""
    plugin = (control.plugin or "").strip()
    known = catalog.hardware(plugin, distro) if plugin else None
    return (known.simulator if known else None) or ""


def movers_of(project: Project) -> str:
    """Return which plugins of a simulator move joints of a robot without controllers, in words; empty if none do."""
    if project.controllers is not None and project.controllers.controllers:
        return ""
    moving = (each for each in loaded_plugins(project) if each.drives or each.moves_joints)
    names = list(dict.fromkeys(f"'{each.filename}'" for each in moving))
    return f"plugin{'s' * (len(names) > 1)} {enumerated(names, 'and')} of the simulator" if names else ""


def in_gazebo_of_ros1(project: Project) -> bool:
    """Return whether Gazebo's default hardware simulation of ROS 1 certainly runs a robot."""
    return in_gazebo(project) is Severity.ERROR


def in_simulation(project: Project, distro: str) -> bool:
    """Return whether a simulator with gravity certainly runs a robot."""
    if generation(distro) == 1:
        return in_gazebo_of_ros1(project)
    controls = project.robot.ros2_controls if project.robot else ()
    return any(simulator_of(control, project.catalog, distro) in _WORLDS for control in controls)
