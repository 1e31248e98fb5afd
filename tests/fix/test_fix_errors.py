"""Fixes of errors: those that leave a warning are kept and say so."""

from __future__ import annotations

import json

from folder import Folder
from robots import whole

COMPONENT = """<ros2_control name="arm" type="system">
  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
  <transmission name="elbow_transmission">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"><hardwareInterface>EffortJointInterface</hardwareInterface></joint>
    <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
  </transmission>
</ros2_control>
"""
WHEELS = "".join(
    f"""<transmission name="{joint}_trans">
  <type>transmission_interface/SimpleTransmission</type>
  <joint name="{joint}"><hardwareInterface>{prefix}EffortJointInterface</hardwareInterface></joint>
  <actuator name="{joint}_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
</transmission>
"""
    for joint, prefix in (("shoulder", "hardware_interface/"), ("elbow", ""))
)
GAZEBO = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
DRIVE = """
joints: {type: joint_state_controller/JointStateController, publish_rate: 50}
drive: {type: diff_drive_controller/DiffDriveController, left_wheel: shoulder, right_wheel: elbow}
"""


def test_a_transmission_of_ros_1_in_a_component_becomes_a_joint(folder: Folder) -> None:
    folder.write({"arm.urdf": whole("arm.urdf", COMPONENT)})
    ran = folder.run("lint", "arm.urdf", "--distro", "jazzy", "--unsafe-fixes", "--select", "UC3,UC4")
    text = (folder.path / "arm.urdf").read_text()
    assert "<transmission" not in text
    assert (
        '<joint name="elbow"><command_interface name="effort"/><state_interface name="position"/>'
        '<state_interface name="velocity"/><state_interface name="effort"/></joint>'
    ) in text
    assert ran.returncode == 0


def test_transmissions_get_the_interface_of_a_controller_that_has_no_other_type(folder: Folder) -> None:
    folder.write({"robot.urdf": whole("robot.urdf", WHEELS + GAZEBO), "c.yaml": DRIVE})
    command = ("lint", "robot.urdf", "c.yaml", "--distro", "noetic", "--simulator", "gazebo-classic")
    found = json.loads(folder.run(*command, "--format", "json", "--select", "UC461").stdout)["findings"]
    assert [one["code"] for one in found] == ["UC461"]
    assert [edit["text"] for edit in found[0]["fix"]["edits"]] == [
        "hardware_interface/VelocityJointInterface",
        "VelocityJointInterface",
    ]
    folder.run(*command, "--unsafe-fixes", "--select", "UC461")
    assert (folder.path / "robot.urdf").read_text().count("VelocityJointInterface") == 2


def test_a_fix_that_leaves_a_warning_in_place_of_an_error_is_kept_and_says_so(folder: Folder) -> None:
    state = "{type: joint_state_broadcaster/JointStateBroadcaster}"
    yaml = f"controller_manager:\n  ros__parameters: {{update_rate: 100, one: {state}, two: {state}}}\n"
    folder.write({"arm.urdf": whole("arm.urdf", COMPONENT), "c.yaml": yaml})
    command = ("lint", "arm.urdf", "c.yaml", "--distro", "jazzy", "--start", "one,two")
    ran = folder.run(*command, "--unsafe-fixes", "--select", "UC324")
    assert "<transmission" not in (folder.path / "arm.urdf").read_text()
    assert "an error is fixed; left is UC466: controller 'two' publishes the same joint states" in ran.stderr
    assert "fixed 1 of 1 finding in 1 file" in ran.stderr
