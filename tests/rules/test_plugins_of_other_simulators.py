"""Plugins of Gazebo Classic in a robot for gz: that they are not loaded is told, and nothing about their settings."""

from __future__ import annotations

import pytest
from robots import Robot

FILE = "<parameters>/opt/arm/controllers.yaml</parameters>"
CONTROL = """
<ros2_control name="arm" type="system">
  <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
</ros2_control>
"""
GZ = f"""
<gazebo>
  <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">{FILE}</plugin>
</gazebo>
"""
CLASSIC = f"""
<gazebo>
  <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">{FILE}</plugin>
</gazebo>
"""
POSE = """
<gazebo>
  <plugin name="pose" filename="libgazebo_ros_p3d.so"><bodyName>fore</bodyName><updateRate>50</updateRate></plugin>
</gazebo>
"""
IMU = """
<gazebo reference="fore">
  <sensor name="imu" type="imu"><plugin name="imu" filename="libgazebo_ros_imu_sensor.so"/></sensor>
</gazebo>
"""


@pytest.mark.parametrize(("distro", "told"), [("humble", "warning UC534"), ("jazzy", "info UC701")])
def test_a_plugin_that_gz_does_not_load_is_told_once_and_its_settings_are_not(
    robot: Robot, distro: str, told: str
) -> None:
    assert robot.says(CONTROL + GZ + POSE, distro=distro) == [told]
    assert robot.says(CONTROL + GZ + IMU, distro=distro) == [told]


def test_its_settings_are_judged_where_the_robot_is_for_gazebo_classic(robot: Robot) -> None:
    found = robot.says(POSE, distro="humble")
    assert "warning UC511" in found
    assert "warning UC534" not in found


def test_a_robot_for_both_simulators_needs_the_plugins_of_both(robot: Robot) -> None:
    assert "warning UC534" not in robot.says(CONTROL + GZ + CLASSIC + POSE, distro="humble")
    assert "warning UC534" not in robot.says(CONTROL + GZ + CLASSIC + POSE, distro="humble", simulator="gz")


def test_a_plugin_that_no_catalogue_has_may_be_for_gz(robot: Robot) -> None:
    assert robot.says(CONTROL + GZ + POSE.replace("libgazebo_ros_p3d.so", "libour_pose.so"), distro="humble") == []
