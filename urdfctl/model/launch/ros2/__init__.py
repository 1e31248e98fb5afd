"""Build the model of ROS 2 launch files, which are followed without running anything."""

from __future__ import annotations

from urdfctl.model.launch.ros2.build_launch_ros2 import launch_of_ros2
from urdfctl.model.launch.ros2.sources import Ros2Sources

__all__ = [
    "Ros2Sources",
    "launch_of_ros2",
]
