"""A spawner may give the type of a controller, in the distros that have the option."""

from __future__ import annotations

import pytest
from folder import Folder
from generating import command

LAUNCH = """
import os
from launch import LaunchDescription
from launch_ros.actions import Node

FILE = os.path.join(os.path.dirname(__file__), "controllers.yaml")

def generate_launch_description():
    return LaunchDescription([
        Node(package="controller_manager", executable="ros2_control_node", parameters=[FILE]),
        Node(package="controller_manager", executable="spawner", arguments=["arm"{more}]),
    ])
"""
TYPE = ', "--controller-type", "forward_command_controller/ForwardCommandController"'
CONTROLLERS = """\
controller_manager:
  ros__parameters: {update_rate: 100}
arm:
  ros__parameters: {joints: [elbow], interface_name: position}
"""


@pytest.mark.parametrize(
    ("more", "distro", "told"), [(TYPE, "humble", False), (TYPE, "jazzy", True), ("", "humble", True)]
)
def test_a_type_that_the_spawner_gives_is_not_missing(more: str, distro: str, told: bool, folder: Folder) -> None:
    folder.write({"arm.launch.py": LAUNCH.format(more=more), "controllers.yaml": CONTROLLERS})
    shown = command("lint", "arm.launch.py", "--distro", distro).stdout
    assert ("controller 'arm' has no type" in shown) is told, shown
