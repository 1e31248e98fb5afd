"""A launch file that starts no known robot says why, and what to start or to add instead."""

from __future__ import annotations

import pytest
from folder import Folder
from generating import command

PACKAGE = """<package format="2"><name>a</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.c">a</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>
"""
ARM = """<robot name="arm"><link name="base"/><link name="tip"/>
<joint name="weld" type="fixed"><parent link="base"/><child link="tip"/></joint></robot>"""
DESCRIBED = """<launch>
  <param name="robot_description" command="$(find xacro)/xacro '$(find a)/urdf/arm.urdf'"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="mover"/>
</launch>
"""
MANAGED = 'Node(package="controller_manager", executable="ros2_control_node")'
STARTS_NONE = (
    "from launch import LaunchDescription\n\ndef generate_launch_description():\n    return LaunchDescription([{}])\n"
)
HEAD = "import os\nfrom launch.actions import IncludeLaunchDescription\nfrom pathlib import Path\n"
INCLUDED = (
    'IncludeLaunchDescription(str(Path(get_package_share_directory("arm_model")) / "launch" / "description.launch.py"))'
)


def test_the_package_of_an_included_launch_file_is_named_however_its_path_is_made(folder: Folder) -> None:
    text = f"{HEAD}from ament_index_python.packages import get_package_share_directory\n{STARTS_NONE.format(INCLUDED)}"
    folder.write({"a/package.xml": PACKAGE, "a/launch/one.launch.py": text})
    shown = command("smoke", "a/launch/one.launch.py", "--engine", "none", "--distro", "jazzy").stdout
    assert "it needs files of package 'arm_model', not here: clone it beside it" in shown
    assert "nothing was tested: add what is missing" in shown


@pytest.mark.parametrize(
    ("cmake", "when"),
    [("", ":"), ("configure_file(arm.urdf.in arm.urdf)\n", " before the build: build the workspace, or")],
)
@pytest.mark.parametrize("loads", [True, False])
def test_a_description_that_does_not_exist_is_named(cmake: str, when: str, loads: bool, folder: Folder) -> None:
    load = '<rosparam command="load" file="$(find a)/config/arm.yaml"/>' if loads else ""
    folder.write(
        {
            "a/package.xml": PACKAGE,
            "a/CMakeLists.txt": f"project(a)\nfind_package(catkin REQUIRED)\n{cmake}",
            "a/config/arm.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
            "a/launch/one.launch": DESCRIBED.replace("</launch>", f"{load}</launch>"),
        }
    )
    shown = command("smoke", "a/launch/one.launch", "--engine", "none", "--distro", "noetic").stdout
    assert f"reads the robot from 'a/urdf/arm.urdf', which does not exist{when} urdfctl smoke ROBOT" in shown


def test_a_launch_file_that_starts_no_robot_names_those_that_do(folder: Folder) -> None:
    folder.write({"a/package.xml": PACKAGE, "a/launch/teleop.launch.py": STARTS_NONE.format("")})
    words = ("smoke", "a/launch/teleop.launch.py", "--engine", "none", "--distro", "jazzy")
    alone = command(*words)
    assert "  it starts no robot\nno findings" in alone.stdout
    assert "nothing was tested: no known robot is started" in alone.stdout
    assert alone.returncode == 5
    folder.write({"b/urdf/arm.urdf": ARM})
    assert "the launch file starts no robot: name one, such as b/urdf/arm.urdf\n" in command(*words).stdout
    folder.write({"a/launch/robot.launch.py": f"from launch_ros.actions import Node\n{STARTS_NONE.format(MANAGED)}"})
    expected = "name a launch file that starts a robot, such as a/launch/robot.launch.py\n"
    assert expected in command(*words).stdout


CHOSEN = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from fleet.nodes import nodes_of

def setup(context):
    return nodes_of(LaunchConfiguration("fleet").perform(context))

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("fleet", default_value={!r}),
        DeclareLaunchArgument("prefix", default_value=""),
        OpaqueFunction(function=setup),
    ])
"""


@pytest.mark.parametrize(
    ("default", "given", "expected"),
    [
        ("", [], "known without argument 'fleet': urdfctl smoke one.launch.py fleet:=VALUE"),
        ("", ["fleet:=two"], "known before it runs: urdfctl smoke ROBOT"),
        ("one", [], "known before it runs: urdfctl smoke ROBOT"),
    ],
)
def test_an_empty_argument_that_may_choose_the_robot_is_named(
    default: str, given: list[str], expected: str, folder: Folder
) -> None:
    folder.write({"one.launch.py": CHOSEN.format(default)})
    shown = command("smoke", "one.launch.py", *given, "--engine", "none", "--distro", "jazzy").stdout
    assert f"  it starts no robot that is {expected}\n" in shown


DRIVEN = """<robot name="cart"><link name="base"/>
<link name="left"/><joint name="left_wheel" type="continuous"><parent link="base"/><child link="left"/></joint>
<link name="right"/><joint name="right_wheel" type="continuous"><parent link="base"/><child link="right"/></joint>
{}</robot>"""
PLUGIN = """<gazebo><plugin filename="gz-sim-{}-system" name="gz::sim::systems::DiffDrive">
<left_joint>left_wheel</left_joint><right_joint>right_wheel</right_joint></plugin></gazebo>"""


@pytest.mark.parametrize(("plugin", "named"), [("diff-drive", True), ("pose-publisher", False)])
def test_the_plugin_that_moves_a_robot_without_controllers_is_named(plugin: str, named: bool, folder: Folder) -> None:
    folder.write({"cart.urdf": DRIVEN.format(PLUGIN.format(plugin))})
    shown = command("smoke", "cart.urdf", "--engine", "none", "--distro", "jazzy").stdout
    expected = "for this robot: plugin 'gz-sim-diff-drive-system' of the simulator may move it, which is not tested\n"
    assert (expected in shown) is named


WHEELS = "wheels: {type: velocity_controllers/JointGroupVelocityController, joints: [%s]}\n"


@pytest.mark.parametrize(
    ("joint", "expected"),
    [
        ("left_wheel", "no robot uses 'b/wheels.yaml': urdfctl smoke a/cart.urdf --controllers b/wheels.yaml"),
        ("left_wheel_1", "no controllers found; name their file with --controllers, or see what 'urdfctl gen-all"),
    ],
)
def test_a_controller_file_of_another_package_is_named_if_it_names_joints_of_the_robot(
    joint: str, expected: str, folder: Folder
) -> None:
    folder.write({"a/package.xml": PACKAGE, "a/cart.urdf": DRIVEN.format(""), "b/wheels.yaml": WHEELS % joint})
    shown = command("smoke", "a/cart.urdf", "--engine", "none", "--distro", "noetic").stdout
    assert f"nothing was tested: {expected}" in shown
