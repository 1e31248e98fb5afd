"""Files that a build file installs and that do not exist, in each package whose files a robot is started with."""

from __future__ import annotations

from folder import Folder

MANIFEST = """\
<package format="3">
  <name>{}</name>
  <exec_depend>arm_description</exec_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
"""
BUILD = "find_package(ament_cmake REQUIRED)\ninstall(PROGRAMS {} DESTINATION lib/x)\nament_package()\n"
LAUNCH = """\
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    given = {"robot_description": Command(["xacro ", FindPackageShare("arm_description"), "/urdf/arm.urdf"])}
    node = Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[given])
    return LaunchDescription([node])
"""


def test_the_package_of_a_launch_file_is_meant_too(folder: Folder) -> None:
    folder.write(
        {
            "arm_description/package.xml": MANIFEST.format("arm_description"),
            "arm_description/CMakeLists.txt": BUILD.format("tools/there.py"),
            "arm_description/tools/there.py": "",
            "arm_description/urdf/arm.urdf": '<robot name="arm"><link name="base"/></robot>',
            "arm_bringup/package.xml": MANIFEST.format("arm_bringup"),
            "arm_bringup/CMakeLists.txt": BUILD.format("scripts/gone.py"),
            "arm_bringup/launch/arm.launch.py": LAUNCH,
        }
    )
    shown = folder.run("lint", ".", "--select", "UC637", "--format", "concise").stdout.splitlines()
    assert [line.partition(": warning")[0] for line in shown] == ["arm_bringup/CMakeLists.txt:2:18"]
