"""The simulator of a start is the one that its launch file starts: a plugin in the robot alone starts none."""

from __future__ import annotations

import json

import pytest
from folder import Folder
from generating import command

ROBOT = """<robot name="wren"><link name="body"/><link name="wing"/>
  <joint name="shoulder" type="fixed"><parent link="body"/><child link="wing"/></joint>
  <gazebo><plugin name="control" filename="libgazebo_ros2_control.so"><parameters>x.yaml</parameters></plugin></gazebo>
</robot>"""
MANIFEST = "<package format='3'><name>wren</name></package>"
LAUNCH = """import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

def generate_launch_description():
    share = get_package_share_directory('wren')
    text = open(os.path.join(share, 'wren.urdf')).read()
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{{'robot_description': text}}]),
        {other},
    ])
"""
RVIZ = "Node(package='rviz2', executable='rviz2')"
SPAWN = "Node(package='gazebo_ros', executable='spawn_entity.py', arguments=['-topic', 'robot_description'])"
CONTROLLERS = "Node(package='controller_manager', executable='spawner', arguments=['shoulder_controller'])"
DRIVER = """IncludeLaunchDescription(PythonLaunchDescriptionSource(
            os.path.join(get_package_share_directory('of_others'), 'launch', 'driver.launch.py')))"""
ELSEWHERE = """IncludeLaunchDescription(PythonLaunchDescriptionSource(
            os.path.join(get_package_share_directory('of_others'), 'launch', 'world.launch.py')))"""


@pytest.mark.parametrize(
    ("other", "simulator"),
    [
        (RVIZ, None),
        (SPAWN, "gazebo-classic"),
        (CONTROLLERS, "gazebo-classic"),
        (ELSEWHERE, "gazebo-classic"),
        (DRIVER, None),
    ],
    ids=["only shown", "a model is spawned", "controllers wait", "a world is not here", "a driver is not here"],
)
def test_a_plugin_counts_where_something_needs_the_simulator_or_is_unknown(
    folder: Folder, other: str, simulator: str | None
) -> None:
    folder.write({"package.xml": MANIFEST, "wren.urdf": ROBOT, "launch/start.launch.py": LAUNCH.format(other=other)})
    [target] = json.loads(command("show", "--format", "json").stdout)["targets"]
    assert target["simulator"] == simulator
