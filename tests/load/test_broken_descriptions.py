"""A description that is not well-formed still says which files belong to the robot."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>crane</name><exec_depend>gazebo_ros2_control</exec_depend></package>"
ROBOT = """<robot name="crane" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="file" default="hooks.yaml"/>
  <xacro:include filename="$(find crane)/urdf/control.xacro"/>
  <link name="world"/>
  <link name="boom">
    <inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
  </link>
  <joint name="hoist" type="continuous"><parent link="world"/><child link="boom"/><axis xyz="0 0 1"/></joint>
</robot>"""
CONTROL = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <ros2_control name="crane" type="system">
    <hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>
    <joint name="hoist"><command_interface name="velocity"/><state_interface name="velocity"/></joint>
  </ros2_control>
  <gazebo>
    <plugin name="control" filename="libgazebo_ros2_control.so">
      <parameters>$(find crane)/config/$(arg file)</parameters>
    </plugin>
  </gazebo>
</robot>"""
HOOKS = """controller_manager:
  ros__parameters:
    update_rate: 50
    hoisting: {type: velocity_controllers/JointGroupVelocityController}
hoisting:
  ros__parameters:
    joints: [hoist]
"""


def package(folder: Folder, robot: str, control: str = CONTROL) -> None:
    files = {"package.xml": MANIFEST, "urdf/crane.xacro": robot, "urdf/control.xacro": control}
    folder.write({**files, "config/hooks.yaml": HOOKS})


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('<link name="world"/>', '<link name="world"'),
        ('<link name="world"/>', "<link name=world/>"),
        ("</joint>", ""),
        ("</robot>", ""),
    ],
    ids=["an open tag", "no quotes", "an element without an end", "a root without an end"],
)
def test_the_controllers_of_a_broken_description_are_joined(folder: Folder, before: str, after: str) -> None:
    package(folder, ROBOT.replace(before, after))
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    (target,) = shown["targets"]
    assert target["controllers"] == ["config/hooks.yaml"]
    assert not target["complete"]


@pytest.mark.parametrize("broken", ["robot", "part"])
def test_only_the_mistake_is_told_and_no_file_is_unused(folder: Folder, broken: str) -> None:
    robot, control = ROBOT, CONTROL
    if broken == "robot":
        robot = ROBOT.replace('default="hooks.yaml"/>', "defaul")
    else:
        control = CONTROL.replace('name="control"', 'name="control')
    package(folder, robot, control)
    result = folder.run("lint", ".", "--format", "json")
    assert [finding["code"] for finding in json.loads(result.stdout)["findings"]] == ["UC001"]
    assert "not used" not in result.stderr


def test_a_mistake_behind_a_mistake_is_told_in_the_same_run(folder: Folder) -> None:
    package(
        folder, ROBOT.replace('<link name="world"/>', '<link name="world"'), CONTROL.replace("<hardware>", "<hardware")
    )
    findings = json.loads(folder.run("lint", ".", "--format", "json").stdout)["findings"]
    told = [(one["file"], one["code"]) for one in findings]
    assert told == [("urdf/control.xacro", "UC001"), ("urdf/crane.xacro", "UC001")]


def test_the_same_package_without_a_mistake_has_no_error_and_no_warning(folder: Folder) -> None:
    package(folder, ROBOT)
    findings = json.loads(folder.run("lint", ".", "--format", "json").stdout)["findings"]
    assert not [finding for finding in findings if finding["severity"] != "info"]
