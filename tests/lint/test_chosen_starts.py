"""Launch files that others include only with an argument, by a part of their name or where Python compares it."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package format='{}'><name>hoist</name><buildtool_depend>{}</buildtool_depend></package>"
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
HOIST = f"""<robot name="hoist">
  <link name="base">{MASS}</link>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="hook"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="9" velocity="1"/></joint>
  <link name="hook">{MASS}</link>
</robot>"""
SPAWNER = '<node name="{0}" pkg="controller_manager" type="spawner" args="states {0}"/>'
WORLD = """<launch>
  <arg name="kind" default="slow"/>
  <param name="robot_description" textfile="$(find hoist)/hoist.urdf"/>
  <include file="$(find hoist)/launch/{}.launch"/>
</launch>"""
PYTHON = """
import xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

def start(context):
    share = get_package_share_directory("hoist")
    described = {{"robot_description": xacro.process_file(share + "/hoist.urdf").toxml()}}
    if context.launch_configurations["kind"] == "{}":
        included = share + "/launch/fast.launch.py"
    else:
        included = share + "/launch/slow.launch.py"
    return [
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[described]),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(included)),
    ]

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument("kind", default_value="slow"), OpaqueFunction(function=start)])
"""
SPAWNING = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([Node(package="controller_manager", executable="spawner", arguments=["states", "{}"])])
"""


def shown(folder: Folder) -> tuple[list[dict[str, str]], list[str]]:
    """The arguments of each start, and the launch files that are joined with no robot."""
    given = json.loads(folder.run("show", ".", "--format", "json").stdout)
    starts = [each["launch_arguments"] for each in given["targets"] if each["launch"]]
    return starts, [each["launch"] for each in given["unjoined"]]


@pytest.mark.parametrize(
    ("name", "starts", "left"),
    [
        ("$(arg kind)_control", [{}, {"kind": "fast"}], []),
        ("slow_control", [{}], ["launch/fast_control.launch"]),
    ],
)
def test_an_argument_that_is_a_part_of_the_name_starts_the_other_launch_files(
    folder: Folder, name: str, starts: list[dict[str, str]], left: list[str]
) -> None:
    files = {f"launch/{kind}_control.launch": f"<launch>{SPAWNER.format(kind)}</launch>" for kind in ("fast", "slow")}
    folder.write({"package.xml": MANIFEST.format(2, "catkin"), "hoist.urdf": HOIST, **files})
    folder.write({"launch/world.launch": WORLD.format(name)})
    assert shown(folder) == (starts, left)


@pytest.mark.parametrize(
    ("compared", "starts", "left"),
    [("fast", [{}, {"kind": "fast"}], []), ("slow", [{}], ["launch/slow.launch.py"])],
)
def test_an_argument_that_python_compares_starts_what_is_in_the_other_branch(
    folder: Folder, compared: str, starts: list[dict[str, str]], left: list[str]
) -> None:
    """With `slow`, the default, which is compared, the other branch is for values that nothing names."""
    files = {f"launch/{kind}.launch.py": SPAWNING.format(kind) for kind in ("fast", "slow")}
    folder.write({"package.xml": MANIFEST.format(3, "ament_cmake"), "hoist.urdf": HOIST, **files})
    folder.write({"launch/world.launch.py": PYTHON.format(compared)})
    assert shown(folder) == (starts, left)


def test_what_another_start_includes_is_no_reason_to_choose_an_argument(folder: Folder) -> None:
    files = {f"launch/{kind}_control.launch": f"<launch>{SPAWNER.format(kind)}</launch>" for kind in ("fast", "slow")}
    folder.write({"package.xml": MANIFEST.format(2, "catkin"), "hoist.urdf": HOIST, **files})
    folder.write({"launch/world.launch": WORLD.format("$(arg kind)_control")})
    folder.write({"launch/race.launch": WORLD.format("fast_control")})
    assert shown(folder) == ([{}, {}], [])
