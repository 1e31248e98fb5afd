"""A package with files that a migration changes."""

from __future__ import annotations

from folder import Folder

MANIFEST = '<package format="3"><name>arm</name></package>\n'
ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="tip"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
  <!-- the hardware -->
  <ros2_control name="arm"   type="system">
    <hardware><plugin>ign_ros2_control/IgnitionSystem</plugin></hardware>
    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>
"""
MIGRATED = ROBOT.replace("ign_ros2_control/IgnitionSystem", "gz_ros2_control/GazeboSimSystem")
FILES = {"arm/package.xml": MANIFEST, "arm/urdf/arm.urdf.xacro": ROBOT}


def content(folder: Folder, path: str = "arm") -> dict[str, bytes]:
    """The files below a folder, by their names."""
    root = folder.path / path
    return {file.relative_to(root).as_posix(): file.read_bytes() for file in root.rglob("*") if file.is_file()}
