"""Nodes that launch files for ROS 2 start by a command: `ros2 run`, and programs that FindExecutable names."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>hoist</name><export><build_type>ament_cmake</build_type></export></package>"
HOIST = """<robot name="hoist"><link name="base"/><link name="hook"/>
  <joint name="lift" type="fixed"><parent link="base"/><child link="hook"/></joint></robot>"""
LAUNCH = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import FindExecutable

def generate_launch_description():
    hoist = get_package_share_directory("hoist") + "/hoist.urdf"
    return LaunchDescription([ExecuteProcess(cmd={}), ExecuteProcess(cmd=["gz", "sim", "-r", "empty.sdf"])])
"""


def shown(folder: Folder, command: str) -> list[tuple[str | None, str, str | None]]:
    folder.write({"package.xml": MANIFEST, "hoist.urdf": HOIST, "launch/up.launch.py": LAUNCH.format(command)})
    given = json.loads(folder.run("show", ".", "--format", "json").stdout)
    return [(each["launch"], each["robot"], each["simulator"]) for each in given["targets"]]


@pytest.mark.parametrize(
    "command",
    [
        '["ros2", "run", "ros_gz_sim", "create", "-file", hoist, "-name", "hoist"]',
        '[FindExecutable(name="ros2"), "run", "ros_gz_sim", "create", "-file", hoist]',
        '[[FindExecutable(name="ros2"), " run ros_gz_sim create -file ", hoist]], shell=True',
        '["ros2", "run", "robot_state_publisher", "robot_state_publisher", hoist]',
    ],
)
def test_a_node_that_a_command_runs_gets_the_description_that_is_named_for_it(folder: Folder, command: str) -> None:
    assert shown(folder, command) == [("launch/up.launch.py", "hoist.urdf", "gz")]


@pytest.mark.parametrize("command", ['["ros2", "run", "urdf_viewer", "view", "-f", hoist]', '["ros2", "run"]'])
def test_a_file_that_another_program_reads_is_not_a_robot_that_is_started(folder: Folder, command: str) -> None:
    assert shown(folder, command) == [(None, "hoist.urdf", None)]


def test_controllers_that_a_command_loads_are_found_however_its_program_is_named(folder: Folder) -> None:
    command = '[[FindExecutable(name="ros2"), " control load_controller --set-state active lift"]], shell=True'
    folder.write({"package.xml": MANIFEST, "launch/up.launch.py": LAUNCH.format(command)})
    given = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [each["launch"] for each in given["unjoined"]] == ["launch/up.launch.py"]
