"""A launch file that reads MoveIt's list of controllers out of a MoveItConfigsBuilder spawns what is in that list."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>winch_moveit_config</name></package>"
ROBOT = "<robot name='winch'><link name='drum'/></robot>"
LISTED = "moveit_simple_controller_manager:\n  controller_names: [{}]\n"
LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder

def generate_launch_description():
    config = MoveItConfigsBuilder("winch"){calls}.to_moveit_configs()
    description = LaunchDescription()
    description.add_action(Node(package="robot_state_publisher", executable="robot_state_publisher",
                                parameters=[config.robot_description]))
    for name in {names} + ["joint_state_broadcaster"]:
        description.add_action(Node(package="controller_manager", executable="spawner", arguments=[name]))
    return description
"""
GOTTEN = "config.trajectory_execution.get('moveit_simple_controller_manager', {}).get('controller_names', [])"
TAKEN = "config.trajectory_execution['moveit_simple_controller_manager']['controller_names']"
NAMED = ".trajectory_execution(file_path='config/by_hand.yaml')"


def started(folder: Folder, names: str, calls: str = "", **files: str) -> tuple[list[str], list[str]]:
    folder.write(
        {
            "package.xml": MANIFEST,
            "config/winch.urdf.xacro": ROBOT,
            "launch/up.launch.py": LAUNCH.format(names=names, calls=calls),
            **{f"config/{name}.yaml": text for name, text in files.items()},
        }
    )
    shown = folder.run("show", ".").stdout
    found: dict[str, Any] = json.loads(folder.run("show", ".", "--format", "json").stdout)
    spawned = found["targets"][0]["spawned"]
    return spawned, [line for line in shown.splitlines() if line.startswith("  unknown")]


@pytest.mark.parametrize("names", [GOTTEN, TAKEN])
def test_the_usual_list_is_spawned(folder: Folder, names: str) -> None:
    spawned, unknown = started(folder, names, moveit_controllers=LISTED.format("lifter"))
    assert (spawned, unknown) == (["lifter", "joint_state_broadcaster"], [])


def test_the_list_of_the_named_file_is_spawned(folder: Folder) -> None:
    files = {"moveit_controllers": LISTED.format("lifter"), "by_hand": LISTED.format("slow, fast")}
    spawned, unknown = started(folder, GOTTEN, NAMED, **files)
    assert (spawned, unknown) == (["slow", "fast", "joint_state_broadcaster"], [])


def test_a_file_without_a_list_leaves_what_the_launch_file_says(folder: Folder) -> None:
    spawned, unknown = started(folder, GOTTEN, moveit_controllers="moveit_manage_controllers: true\n")
    assert (spawned, unknown) == (["joint_state_broadcaster"], [])


def test_a_file_that_is_not_there_leaves_controllers_unknown(folder: Folder) -> None:
    spawned, unknown = started(folder, GOTTEN, NAMED, moveit_controllers=LISTED.format("lifter"))
    assert spawned == ["joint_state_broadcaster"]
    assert unknown == ["  unknown     some of what the launch file starts could not be determined"]
