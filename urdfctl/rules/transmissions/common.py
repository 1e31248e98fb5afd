"""What the rules on ROS 1 transmissions share."""

from __future__ import annotations

from urdfctl.catalog.distros import since
from urdfctl.model.project import Project
from urdfctl.model.transmission import Transmission

PREFIX = "hardware_interface/"


def read_transmissions(project: Project) -> tuple[Transmission, ...]:
    """The transmissions that ros_control's parser reads: those of its own form, directly in the root element."""
    if project.robot is None:
        return ()
    return tuple(transmission for transmission in project.robot.transmissions if not transmission.is_pr2)


def takes_prefix(project: Project) -> bool:
    """Whether Gazebo's hardware simulation takes `hardware_interface/...`: from kinetic on (default_robot_hw_sim.cpp)."""
    return bool(set(project.distros) & set(since("kinetic")))


def with_prefix(interface: str, project: Project) -> str:
    """An interface's name in the form that the project's distro takes."""
    bare = interface.removeprefix(PREFIX)
    return PREFIX + bare if takes_prefix(project) else bare
