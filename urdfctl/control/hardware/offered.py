"""The hardware of a project, as one distro makes it from the description."""

from __future__ import annotations

from urdfctl.catalog.distros import generation
from urdfctl.control.hardware.interfaces import UNKNOWN_HARDWARE, OfferedHardware
from urdfctl.model.project import Project


def hardware_of(project: Project, distro: str) -> OfferedHardware:
    """Return the hardware of a robot in one distro."""
    if project.robot is None:
        return UNKNOWN_HARDWARE
    if generation(distro) == 1:
        from urdfctl.control.hardware.gazebo_ros1 import has_own_simulation
        from urdfctl.control.hardware.ros1 import simulated_hardware

        return UNKNOWN_HARDWARE if has_own_simulation(project) else simulated_hardware(project.robot)
    from urdfctl.control.hardware.ros2 import described_hardware

    return described_hardware(project.robot, project.catalog, distro)
