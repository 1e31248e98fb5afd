"""Robots are tested as launch files start them; an argument that a launch file needs has a value that exists."""

from __future__ import annotations

import pytest
from folder import Folder
from generating import command

NO_ENGINE = ("--engine", "none", "--distro", "jazzy")
ROBOT = """
<robot name="arm">
  <link name="world"/>
  <link name="fore">
    <inertial><mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="elbow" type="revolute">
    <parent link="world"/><child link="fore"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="5" velocity="1"/>
  </joint>
  <ros2_control name="arm" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
CONTROLLERS = """
controller_manager:
  ros__parameters:
    update_rate: 100
    mover: {type: forward_command_controller/ForwardCommandController}
mover:
  ros__parameters: {joints: [elbow], interface_name: %s}
"""
LAUNCH = """
<launch>
  <arg name="model"/>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'cat $(dirname)/urdf/$(var model).urdf')" type="str"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(dirname)/controllers.yaml"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="mover"/>
</launch>
"""


@pytest.fixture
def arms(folder: Folder) -> Folder:
    """A launch file that starts one of several robots, whose name is an argument without a default."""
    robots = {f"urdf/{name}.urdf": ROBOT for name in ("left", "right", "spare", "tall")}
    folder.write({**robots, "controllers.yaml": CONTROLLERS % "position", "arm.launch.xml": LAUNCH})
    return folder


def test_a_launch_file_is_started_with_the_first_values_of_the_argument_that_it_needs(arms: Folder) -> None:
    ran = command("smoke", "arm.launch.xml", *NO_ENGINE)
    assert ran.returncode == 0, ran.stdout
    started = [line.split()[1] for line in ran.stdout.splitlines() if "model:=" in line]
    assert started == ["model:=left:", "model:=tall:", "model:=right:"]
    assert ran.stdout.count("mover  skipped") == 3


def test_what_fails_only_with_guessed_arguments_is_a_warning(arms: Folder) -> None:
    arms.write({"controllers.yaml": CONTROLLERS % "effort"})
    ran = command("smoke", "arm.launch.xml", *NO_ENGINE)
    assert ran.returncode == 0, ran.stdout
    assert "with guessed arguments it fails: no hardware offers the command interface 'elbow/effort'" in ran.stdout
    assert "note: the launch file needs arguments; their values are guessed from the files that exist" in ran.stdout


def test_the_value_that_the_user_gives_is_not_guessed(arms: Folder) -> None:
    arms.write({"controllers.yaml": CONTROLLERS % "effort"})
    ran = command("smoke", "arm.launch.xml", "model:=spare", *NO_ENGINE)
    assert ran.returncode == 1, ran.stdout
    assert "urdf/spare.urdf" in ran.stdout
    assert ran.stdout.count("mover  failed") == 1


def test_a_description_of_a_folder_is_tested_only_as_a_launch_file_starts_it(folder: Folder) -> None:
    plugin = f"""<gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>{folder.path}/controllers.yaml</parameters>
      </plugin>
    </gazebo>
    </robot>"""
    robot = ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    argument = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="side" default="right"/>'
    robot = robot.replace('<robot name="arm">', argument).replace("</robot>", plugin)
    launch = LAUNCH.replace("cat $(dirname)/urdf/$(var model).urdf", "xacro $(dirname)/urdf/arm.xacro side:=left")
    spare = "spare:\n  ros__parameters: {joints: [elbow], interface_name: effort}\n"
    declared = "    spare: {type: forward_command_controller/ForwardCommandController}\nmover:"
    folder.write(
        {
            "package.xml": '<package format="3"><name>arm</name></package>',
            "urdf/arm.xacro": robot,
            "controllers.yaml": CONTROLLERS.replace("mover:\n  ros", f"{declared}\n  ros") % "position" + spare,
            "arm.launch.xml": launch.replace('<arg name="model"/>', ""),
        }
    )
    alone = command("smoke", "urdf/arm.xacro", *NO_ENGINE)
    assert (alone.returncode, "spare  failed" in alone.stdout) == (1, True)
    ran = command("smoke", *NO_ENGINE)
    assert ran.returncode == 0, ran.stdout
    assert "spare  warned   load > configure > activate  most likely not started" in ran.stdout
