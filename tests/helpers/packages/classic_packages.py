"""Packages for Gazebo Classic, and what they are migrated to."""

from __future__ import annotations

from folder import Folder

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>base</name>
  <version>0.1.0</version>
  <description>A base</description>
  <maintainer email="a@example.com">A</maintainer>
  <license>MIT</license>

  <buildtool_depend>ament_cmake</buildtool_depend>

  <exec_depend>gazebo_ros</exec_depend>
  <exec_depend>gazebo_plugins</exec_depend>
  <exec_depend>gazebo_ros2_control</exec_depend>

  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""


def base(gazebo: str) -> str:
    """A base with two wheels."""
    wheels = "".join(
        f"""\
  <link name="{side}_wheel"/>
  <joint name="{side}" type="continuous">
    <parent link="body"/>
    <child link="{side}_wheel"/>
  </joint>
"""
        for side in ("left", "right")
    )
    return f"""\
<robot name="base" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="body"/>
{wheels}{gazebo}</robot>
"""


DRIVE = """\
  <gazebo>
    <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
      <ros>
        <remapping>odom:=wheels/odom</remapping>
      </ros>
      <left_joint>left</left_joint>
      <right_joint>right</right_joint>
      <wheel_separation>0.4</wheel_separation>
      <wheel_diameter>0.2</wheel_diameter>
      <robot_base_frame>body</robot_base_frame>
    </plugin>
  </gazebo>
"""
CONTROL = """\
  <ros2_control name="wheels" type="system">
    <hardware>
      <plugin>gazebo_ros2_control/GazeboSystem</plugin>
    </hardware>
    <joint name="left"><command_interface name="velocity"/><state_interface name="position"/></joint>
  </ros2_control>
  <gazebo>
    <plugin filename="libgazebo_ros2_control.so" name="gazebo_ros2_control">
      <robot_sim_type>gazebo_ros2_control/GazeboSystem</robot_sim_type>
      <parameters>$(find base)/config/controllers.yaml</parameters>
    </plugin>
  </gazebo>
"""
CONTROLLERS = "controller_manager:\n  ros__parameters:\n    update_rate: 100\n"


def migrated(folder: Folder, files: dict[str, str], *words: str) -> dict[str, str]:
    """All files of a package after its migration from humble to jazzy."""
    folder.write({"base/package.xml": MANIFEST, **{f"base/{name}": text for name, text in files.items()}})
    ran = folder.run("migrate", "base", "--from", "humble", "--to", "jazzy", *words, "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    found = (path for path in (folder.path / "new").rglob("*") if path.is_file())
    return {path.relative_to(folder.path / "new").as_posix(): path.read_text() for path in found}
