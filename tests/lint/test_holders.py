"""A finding in a file that serves several robots says for which of them it holds."""

from __future__ import annotations

import json

from folder import Folder

MANIFEST = "<package format='3'><name>p</name><export><build_type>ament_cmake</build_type></export></package>"
CONTROLLERS = """\
controller_manager:
  ros__parameters: {update_rate: 100, arm: {type: joint_trajectory_controller/JointTrajectoryController}}
arm:
  ros__parameters: {joints: [a, b], command_interfaces: [position], state_interfaces: [position]}
"""
LAUNCH = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" type="str" value="$(command 'xacro $(find-pkg-share p)/NAME.urdf')"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node"><param from="$(find-pkg-share p)/c.yaml"/></node>
  <node pkg="controller_manager" exec="spawner" args="arm"/>
</launch>
"""


def robot(*names: str) -> str:
    joints = "".join(
        f"<link name='{name}_link'/><joint name='{name}' type='revolute'><parent link='base'/>"
        f"<child link='{name}_link'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"
        for name in names
    )
    parts = "".join(
        f"<joint name='{name}'><command_interface name='position'/><state_interface name='position'/></joint>"
        for name in names
    )
    control = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    return (
        f"<robot name='r'><link name='base'/>{joints}<ros2_control name='c' type='system'>{control}{parts}"
        "</ros2_control></robot>"
    )


def notes(folder: Folder, **joints: str) -> list[str]:
    """The notes of the errors on the controllers' joints, which all robots share."""
    folder.write({"package.xml": MANIFEST, "c.yaml": CONTROLLERS})
    for name, own in joints.items():
        folder.write({f"{name}.urdf": robot(*own), f"launch/{name}.launch.xml": LAUNCH.replace("NAME", name)})
    ran = folder.run("lint", ".", "--select", "UC440", "--distro", "jazzy", "--format", "json", "--exit-zero")
    return [note["message"] for one in json.loads(ran.stdout)["findings"] for note in one["notes"]]


def test_an_error_of_one_robot_names_it_and_the_others(folder: Folder) -> None:
    assert notes(folder, one="ab", two="ac") == ["this holds for two.urdf, not for one.urdf"]


def test_an_error_of_all_robots_names_none(folder: Folder) -> None:
    assert notes(folder, one="ac", two="ad") == []
    assert notes(folder, one="ab", two="ab") == []


def test_of_many_robots_a_few_are_named(folder: Folder) -> None:
    said = notes(folder, bad="ac", r1="ab", r2="ab", r3="ab", r4="ab")
    assert said == ["this holds for bad.urdf, not for r1.urdf, r2.urdf, r3.urdf, and 1 more"]
