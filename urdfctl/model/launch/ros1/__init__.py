"""Build the model of ROS 1 launch files (roslaunch XML), together with the files that they include."""

from __future__ import annotations

from urdfctl.model.launch.ros1.build_launch_ros1 import launch_of
from urdfctl.model.launch.ros1.elements import is_of_ros2

__all__ = [
    "is_of_ros2",
    "launch_of",
]
