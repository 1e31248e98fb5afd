"""Packages of ROS 1, and what they are migrated to."""

from __future__ import annotations

from folder import Folder

MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>arm</name>
  <version>0.1.0</version>
  <description>An arm</description>
  <maintainer email="a@example.com">A</maintainer>
  <license>MIT</license>

  <buildtool_depend>catkin</buildtool_depend>

  <exec_depend>gazebo_ros_control</exec_depend>
  <exec_depend>joint_state_controller</exec_depend>
</package>
"""
LEG = """\
  <xacro:macro name="leg" params="side *origin">
    <link name="${side}_foot"/>
    <joint name="${side}_knee" type="continuous">
      <xacro:insert_block name="origin"/>
      <parent link="body"/>
      <child link="${side}_foot"/>
    </joint>
    <!-- the motor of the knee -->
    <transmission name="${side}_knee_transmission">
      <type>transmission_interface/SimpleTransmission</type>
      <joint name="${side}_knee"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
      <actuator name="${side}_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
    </transmission>
  </xacro:macro>
"""
EFFORT = """\
arm:
  ctl:
    type: effort_controllers/JointEffortController
    joint: shoulder
"""
PLUGIN = """\
  <gazebo>
    <plugin name="gazebo_ros_control" filename="libgazebo_ros_control.so">
      <robotNamespace>/arm</robotNamespace>
      <robotSimType>gazebo_ros_control/DefaultRobotHWSim</robotSimType>
    </plugin>
  </gazebo>
"""


def arm(transmission: str, more: str = "") -> str:
    """A robot with one joint."""
    return f"""\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
  <link name="upper"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="upper"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
{transmission}{more}</robot>
"""


def transmission(interface: str, reduction: str = "1") -> str:
    """The transmission of the joint."""
    return f"""\
  <transmission name="shoulder_transmission">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="shoulder">
      <hardwareInterface>{interface}</hardwareInterface>
    </joint>
    <actuator name="shoulder_motor">
      <mechanicalReduction>{reduction}</mechanicalReduction>
    </actuator>
  </transmission>
"""


def migrated(folder: Folder, files: dict[str, str], *words: str) -> dict[str, str]:
    """All files of a package after its migration from noetic to jazzy."""
    folder.write({"arm/package.xml": MANIFEST, **{f"arm/{name}": text for name, text in files.items()}})
    ran = folder.run("migrate", "arm", "--from", "noetic", "--to", "jazzy", *words, "-o", "new", "--force")
    assert ran.returncode == 0, ran.stderr
    found = (path for path in (folder.path / "new").rglob("*") if path.is_file())
    return {path.relative_to(folder.path / "new").as_posix(): path.read_text() for path in found}
