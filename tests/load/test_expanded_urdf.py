"""A launch file that runs xacro on a file expands it, whatever its name is; one that only reads it does not."""

from __future__ import annotations

import pytest
from folder import Folder

URDF = """
<robot name="arm">
  <link name="base"/><link name="tip"/>
  <joint name="elbow" type="continuous"><parent link="base"/><child link="tip"/></joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="velocity"/><state_interface name="position"/></joint>
  </ros2_control>
  <gazebo>
    <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <parameters>$(find arm)/config/controllers.yaml</parameters>
    </plugin>
  </gazebo>
</robot>
"""
LAUNCH = """
import os, subprocess, xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node

URDF = os.path.join(get_package_share_directory("arm"), "urdf", "arm.urdf")

def generate_launch_description():
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher",
             parameters=[{{"robot_description": {}}}]),
    ])
"""
CONTROLLERS = """
controller_manager:
  ros__parameters:
    update_rate: 100
    mover: {type: velocity_controllers/JointGroupVelocityController}
mover:
  ros__parameters: {joints: [elbow]}
"""
MANIFEST = '<package format="3"><name>arm</name></package>'


@pytest.mark.parametrize(
    ("text", "loaded"),
    [
        ("xacro.process_file(URDF).toxml()", True),
        ('Command(["xacro ", URDF])', True),
        ('subprocess.check_output(["xacro", URDF])', True),
        ('Command(["cat ", URDF])', False),
        ("open(URDF).read()", False),
    ],
)
def test_what_xacro_expands_names_the_controllers(text: str, loaded: bool, folder: Folder) -> None:
    folder.write({"package.xml": MANIFEST, "urdf/arm.urdf": URDF, "config/controllers.yaml": CONTROLLERS})
    folder.write({"launch/arm.launch.py": LAUNCH.format(text)})
    shown = folder.run("show", "launch/arm.launch.py").stdout
    assert ("config/controllers.yaml" in shown) is loaded
    found = folder.run("lint", "launch/arm.launch.py", "--select", "UC521", "--format", "concise").stdout
    assert ("UC521" in found) is not loaded


@pytest.mark.parametrize(
    ("given", "loaded"),
    [("command=\"xacro '$(find arm)/urdf/arm.urdf'\"", True), ('textfile="$(find arm)/urdf/arm.urdf"', False)],
)
def test_a_launch_file_of_ros_1_expands_what_it_runs_xacro_on(given: str, loaded: bool, folder: Folder) -> None:
    named = URDF.replace('name="elbow" type', "name=\"${'el' + 'bow'}\" type")
    folder.write({"package.xml": "<package><name>arm</name></package>", "urdf/arm.urdf": named})
    folder.write({"launch/arm.launch": f'<launch><param name="robot_description" {given}/></launch>'})
    shown = folder.run("lint", "launch/arm.launch", "--select", "UC33,UC31", "--distro", "humble").stdout
    assert ("elbow" in shown) is not loaded
