"""What a name is that stands where the class of hardware or of a transmission belongs."""

from __future__ import annotations

from urdfctl.rule import Project

_OF_ROS1 = ("gazebo_ros_control", "hardware_interface", "combined_robot_hw")
"""Packages whose classes are ROS 1's; that of ROS 2 with one of these names exports none."""


def other_kind(project: Project, name: str) -> str | None:
    """Return in words what a name is, if it is certainly neither hardware nor a transmission; None if it may be that."""
    distros, catalog = project.distros, project.catalog
    if any(catalog.controller(name, distro) for distro in distros):
        return "a controller"
    if any(name in catalog.known_transmissions(distro) for distro in distros):
        return "a transmission"
    if name.endswith(".so") or any(catalog.simulator_plugin(name, distro) for distro in distros):
        return "a library"
    package, _, rest = name.partition("/")
    return "a class of ROS 1" if rest and package in _OF_ROS1 else None
