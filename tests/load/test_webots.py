"""A robot of Webots: its driver has the description and the controllers, and Webots' world the links and joints."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>newt</name><exec_depend>controller_manager</exec_depend></package>"
DEVICES = """<robot name="Newt">
  <webots>
    <device reference="imu" type="InertialUnit"/>
    <plugin type="webots_ros2_control::Ros2Control"/>
  </webots>
  <ros2_control name="wheels" type="system">
    <hardware><plugin>webots_ros2_control::Ros2ControlSystem</plugin></hardware>
    <joint name="left wheel motor"><command_interface name="velocity"/><state_interface name="position"/></joint>
    <joint name="right wheel motor"><command_interface name="velocity"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>"""
WHEELS = """controller_manager:
  ros__parameters:
    update_rate: 50
    drive: {type: diff_drive_controller/DiffDriveController}
drive:
  ros__parameters:
    left_wheel_names: [left wheel motor]
    right_wheel_names: [right wheel motor]
    wheel_separation: 0.3
    wheel_radius: 0.05
"""
LAUNCH = """import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from webots_ros2_driver.wait_for_controller_connection import WaitForControllerConnection
from webots_ros2_driver.webots_controller import WebotsController
from webots_ros2_driver.webots_launcher import WebotsLauncher

def generate_launch_description():
    share = get_package_share_directory("newt")
    webots = WebotsLauncher(world=os.path.join(share, "worlds", "pond.wbt"), ros2_supervisor=True)
    description = os.path.join(share, "resource", "newt.urdf")
    wheels = os.path.join(share, "config", "wheels.yaml")
    driver = WebotsController(robot_name="Newt", parameters=[{"robot_description": description}, wheels], respawn=True)
    spawner = Node(package="controller_manager", executable="spawner", arguments=["drive"])
    waiting = WaitForControllerConnection(target_driver=driver, nodes_to_start=[spawner])
    return LaunchDescription([webots, webots._supervisor, driver, waiting])
"""
NODE = """Node(package="webots_ros2_driver", executable="driver",
                  parameters=[{"robot_description": description}, wheels])"""


XACRO = DEVICES.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"').replace("left", "$(arg side)")


def package(folder: Folder, launch: str = LAUNCH, wheels: str = WHEELS) -> None:
    files = {"package.xml": MANIFEST, "resource/newt.urdf": DEVICES, "config/wheels.yaml": wheels}
    folder.write({**files, "launch/pond.launch.py": launch})


def findings(folder: Folder, *paths: str) -> list[tuple[str, str]]:
    report = folder.run("lint", *paths or ["."], "--distro=jazzy", "--no-cache", "--format", "json").stdout
    return [(each["code"], each["message"]) for each in json.loads(report)["findings"] if each["severity"] != "info"]


@pytest.mark.parametrize("driver", ["", NODE], ids=["WebotsController", "a node"])
def test_the_driver_joins_the_description_the_controllers_and_what_waits_for_it(folder: Folder, driver: str) -> None:
    written = LAUNCH[LAUNCH.index("WebotsController(robot") : LAUNCH.index("\n    spawner")]
    package(folder, LAUNCH.replace(written, driver or written))
    shown = folder.run("show", ".").stdout
    lines = [" ".join(line.split()) for line in shown.splitlines()]
    assert lines[:5] == [
        "launch/pond.launch.py",
        "description resource/newt.urdf",
        "controllers config/wheels.yaml",
        "spawned drive",
        "simulator webots",
    ]


def test_all_parameter_files_of_the_driver_reach_its_controllers(folder: Folder) -> None:
    manager, drive = WHEELS.split("\ndrive:")
    package(folder, LAUNCH.replace("description}, wheels]", 'description}, wheels, os.path.join(share, "drive.yaml")]'))
    folder.write({"config/wheels.yaml": f"{manager}\n", "drive.yaml": f"drive:{drive}"})
    assert "  controllers config/wheels.yaml, drive.yaml\n" in folder.run("show", ".").stdout


def test_webots_publishes_the_time_beside_a_manager_of_its_own(folder: Folder) -> None:
    manager = """Node(package="controller_manager", executable="ros2_control_node", parameters=[wheels])
    publisher = Node(package="robot_state_publisher", executable="robot_state_publisher",
                     parameters=[{"robot_description": open(description).read(), "use_sim_time": True}])"""
    written = LAUNCH[LAUNCH.index("WebotsController(robot") : LAUNCH.index("\n    spawner")]
    beside = LAUNCH.replace(written, manager).replace("driver, waiting", "driver, publisher, waiting")
    package(folder, beside)
    assert "UC641" not in [code for code, _ in findings(folder)]
    package(folder, beside.replace("webots, webots._supervisor, ", ""))
    assert "UC641" in [code for code, _ in findings(folder)]


def test_the_driver_expands_a_description_with_the_arguments_of_its_parameter(folder: Folder) -> None:
    described = '{"robot_description": description}'
    mapped = LAUNCH.replace(described, described + ', {"xacro_mappings": ["side:=left"]}')
    package(folder, mapped.replace("newt.urdf", "newt.urdf.xacro"))
    folder.write({"resource/newt.urdf.xacro": XACRO})
    assert "newt.urdf.xacro side:=left" in folder.run("show", ".").stdout
    assert [code for code, _ in findings(folder) if code != "UC614"] == []


SUPERVISED = """from launch import LaunchDescription
from launch_ros.actions import Node
from webots_ros2_driver.webots_launcher import WebotsLauncher

def generate_launch_description():
    webots = WebotsLauncher(world="pond.wbt", ros2_supervisor=True)
    publisher = Node(package="robot_state_publisher", executable="robot_state_publisher",
                     parameters=[{"robot_description": "<robot/>", "use_sim_time": True}])
    manager = Node(package="controller_manager", executable="ros2_control_node")
    return LaunchDescription([webots, webots._supervisor, publisher, manager])
"""


def test_the_supervisor_of_webots_publishes_the_time(folder: Folder) -> None:
    folder.write({"package.xml": MANIFEST, "launch/pond.launch.py": SUPERVISED})
    assert "UC641" not in [code for code, _ in findings(folder)]
    folder.write({"launch/pond.launch.py": SUPERVISED.replace("webots, webots._supervisor, ", "")})
    assert "UC641" in [code for code, _ in findings(folder)]


def test_a_description_of_devices_alone_is_sound(folder: Folder) -> None:
    package(folder)
    assert [code for code, _ in findings(folder) if code != "UC614"] == []  # of the packages that are used
    assert [code for code, _ in findings(folder, "resource/newt.urdf") if code != "UC614"] == []


def test_a_wheel_that_is_nearly_a_motor_of_the_description_is_told(folder: Folder) -> None:
    package(folder, wheels=WHEELS.replace("[right wheel motor]", "[right whel motor]"))
    told = [message for code, message in findings(folder) if code == "UC440"]
    assert len(told) == 1
    assert "names joint 'right whel motor'" in told[0]
    assert told[0].endswith("has 'right wheel motor'")


def test_a_robot_without_links_that_is_not_for_webots_is_broken(folder: Folder) -> None:
    folder.write({"newt.urdf": DEVICES.replace("webots>", "devices>")})
    assert ("UC104", "the robot has no <link>; add at least one") in findings(folder, "newt.urdf")
