"""What the generators learn of a robot: its joints, what they carry, where they are, and the control that it has."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from urdfctl.commands.generate.measuring import measure_work
from urdfctl.config.settings import Settings
from urdfctl.generate.robot.facts import JointFacts, PartFacts, RobotFacts
from urdfctl.lint.job import job_for, perform_alone
from urdfctl.load.target import Target

LIFT = """<robot name="lift">
  <link name="base"><inertial><mass value="100"/></inertial></link>
  <link name="mast"><inertial><origin xyz="0 0 1"/><mass value="4"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/></inertial></link>
  <link name="cabin"><inertial><mass value="2"/><origin xyz="0 0.5 0" rpy="0 0 1.5707963267948966"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/></inertial></link>
  <link name="wheel"><collision><geometry><sphere radius="0.2"/></geometry></collision>
    <visual><geometry><cylinder radius="0.3" length="1"/></geometry></visual></link>
  <link name="lost"/><link name="alone"/>
  <joint name="turn" type="revolute"><parent link="base"/><child link="mast"/><axis xyz="0 0 2"/>
    <limit lower="-1" upper="1" effort="40" velocity="2"/></joint>
  <joint name="raise" type="prismatic"><parent link="mast"/><child link="cabin"/><axis xyz="0 0 1"/>
    <origin xyz="1 0 0"/><limit lower="0" upper="2" effort="900" velocity="0.5"/></joint>
  <joint name="roll" type="continuous"><parent link="cabin"/><child link="wheel"/><axis xyz="a b"/>
    <limit lower="-1" upper="1" effort="much" velocity="9"/><mimic joint="turn"/></joint>
  <joint name="stand" type="fixed"><parent link="base"/><child link="feet"/></joint><link name="feet"/>
  <joint name="nowhere" type="continuous"><parent link="lost"/><child link="alone"/><axis xyz="0 0 0"/></joint>
  <joint type="continuous"><parent link="feet"/><child link="toes"/></joint><link name="toes"/>
  PART
</robot>
"""


def facts(folder: Path, part: str = "") -> RobotFacts:
    """The facts of the lift with a part."""
    path = folder / "lift.urdf"
    path.write_text(LIFT.replace("PART", part), encoding="utf-8")
    settings = Settings(workspace=str(folder))
    result = perform_alone(job_for(measure_work, Target(str(path)), settings))
    return RobotFacts.from_json(result["facts"])


def joints(folder: Path) -> dict[str, JointFacts]:
    return {joint.name: joint for joint in facts(folder).joints}


def test_joints_that_move_are_told_from_those_that_do_not(tmp_path: Path) -> None:
    found = facts(tmp_path)
    assert (found.name, found.root, found.fixed) == ("lift", "base", ("stand",))
    assert {joint.name: (joint.type, joint.mimics) for joint in found.joints} == {
        "turn": ("revolute", False),
        "raise": ("prismatic", False),
        "roll": ("continuous", True),
        "nowhere": ("continuous", False),
    }


def test_limits_are_taken_as_they_stand_and_none_of_a_joint_that_goes_on_turning(tmp_path: Path) -> None:
    found = joints(tmp_path)
    assert (found["raise"].lower, found["raise"].upper, found["raise"].effort, found["raise"].velocity) == (
        0,
        2,
        900,
        0.5,
    )
    assert (found["roll"].lower, found["roll"].upper, found["roll"].effort, found["roll"].velocity) == (None,) * 3 + (
        9,
    )


def test_a_joint_carries_all_that_hangs_below_it(tmp_path: Path) -> None:
    found = joints(tmp_path)
    assert found["raise"].inertia == 2.0  # kg: it slides
    assert found["turn"].inertia == pytest.approx(0.3 + 0.3 + 2 * (1 + 0.25))  # 2 kg at (1, 0.5) from the mast
    assert found["roll"].inertia is None  # its wheel weighs nothing


def test_a_wheel_has_the_radius_of_what_touches_the_ground(tmp_path: Path) -> None:
    assert joints(tmp_path)["roll"].radius == 0.2


def test_joints_are_placed_in_the_frame_of_the_root(tmp_path: Path) -> None:
    found = joints(tmp_path)
    assert found["raise"].at == (1.0, 0.0, 0.0)
    assert found["turn"].axis == (0.0, 0.0, 1.0)
    assert found["roll"].axis == (1.0, 0.0, 0.0)  # what an axis is that cannot be read
    assert found["nowhere"].at is None


def test_an_axis_turns_with_the_frames_above_it(tmp_path: Path) -> None:
    part = """<joint name="held" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
      <origin rpy="-1.5707963267948966 0 0"/></joint>
      <link name="arm"><inertial><mass value="1"/><origin xyz="0.5 0 0"/></inertial></link>"""
    held = next(joint for joint in facts(tmp_path, part).joints if joint.name == "held")
    assert held.axis == pytest.approx((0.0, 1.0, 0.0), abs=1e-9)
    assert math.isclose(held.inertia or 0, 0.25)


def test_the_control_that_a_robot_has_is_told(tmp_path: Path) -> None:
    part = """<transmission name="t"><type>transmission_interface/SimpleTransmission</type>
        <joint name="turn"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>
        <actuator name="m"/></transmission>
      <ros2_control name="hw" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>
        <joint name="raise"><command_interface name="position"/><state_interface name="position"/></joint>
        <sensor name="imu"><state_interface name="orientation.x"/></sensor></ros2_control>
      <gazebo><plugin name="p" filename="libgz_ros2_control-system.so"/></gazebo>"""
    found = facts(tmp_path, part)
    assert found.interfaces == {"turn": ("effort",), "raise": ("position",)}
    assert found.of_kind("sensor") == (PartFacts("sensor", "imu", (), ("orientation.x",)),)
    assert found.components == ("hw",)
    assert found.hosts == ("libgz_ros2_control-system.so",)


def test_wheels_that_stand_on_the_ground_carry_their_share_of_the_robot(tmp_path: Path) -> None:
    part = "".join(
        f"""<joint name="{side}" type="continuous"><parent link="base"/><child link="{side}_wheel"/><axis xyz="0 1 0"/>
          <origin xyz="0 {y} -1"/></joint><link name="{side}_wheel"><collision><geometry>
          <sphere radius="0.5"/></geometry></collision></link>"""
        for side, y in (("left", 1), ("right", -1))
    )
    found = {joint.name: joint.inertia for joint in facts(tmp_path, part).joints}
    assert found["left"] == found["right"] == pytest.approx(106 / 2 * 0.5**2)  # 106 kg on two wheels
    assert found["roll"] is None  # it stands in the air


def test_a_robot_that_cannot_be_read_has_no_facts(tmp_path: Path) -> None:
    (tmp_path / "robot.urdf").write_text("<robot", encoding="utf-8")
    settings = Settings(workspace=str(tmp_path))
    result = perform_alone(job_for(measure_work, Target(str(tmp_path / "robot.urdf")), settings))
    assert result["facts"] is None
    assert result["outcome"]
