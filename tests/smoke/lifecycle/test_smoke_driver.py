"""Hardware of ROS 1 that no file describes, and robots that are missing: what is known is tested, the rest is named."""

from __future__ import annotations

from pathlib import Path

from folder import Folder
from smoking import smoked, target_of, verdicts

from urdfctl.lint.planning import PlannedTarget, TargetOrigin
from urdfctl.load.target import Target
from urdfctl.smoke.aside import as_aside
from urdfctl.smoke.results import Verdict

ROBOT = """
<robot name="arm">
  <link name="world"/>
  <link name="base">{mass}</link>
  <joint name="fixed" type="fixed"><parent link="world"/><child link="base"/></joint>
  <link name="hand">{mass}</link>
  <joint name="wrist" type="revolute"><parent link="base"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="9" velocity="2"/></joint>
  {plugin}
</robot>
"""
MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
PLUGIN = '<gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>'
CONTROLLERS = "mover: {type: position_controllers/JointPositionController, joint: wrist}\n"


def test_a_driver_of_ros_1_that_is_not_in_the_files_is_taken_to_offer_what_controllers_claim(tmp_path: Path) -> None:
    files = {"robot.urdf": ROBOT.format(mass=MASS, plugin=""), "controllers.yaml": CONTROLLERS}
    made = smoked(target_of(tmp_path, files), distro="noetic")
    assert verdicts(made) == {"mover": "skipped activate"}
    assert list(made.controllers[0].untested) == ["driver"]


def test_gazebo_offers_only_what_transmissions_name(tmp_path: Path) -> None:
    files = {"robot.urdf": ROBOT.format(mass=MASS, plugin=PLUGIN), "controllers.yaml": CONTROLLERS}
    made = smoked(target_of(tmp_path, files), distro="noetic")
    assert verdicts(made) == {"mover": "failed load"}
    assert made.controllers[0].untested == {}


def test_a_launch_file_without_a_robot_tells_how_to_name_one(tmp_path: Path) -> None:
    launch = """
    <launch>
      <rosparam file="$(dirname)/controllers.yaml"/>
      <node name="spawner" pkg="controller_manager" type="spawner" args="mover"/>
    </launch>
    """
    Folder(tmp_path).write({"controllers.yaml": CONTROLLERS, "control.launch": launch})
    [result] = smoked(Target(str(tmp_path / "control.launch")), distro="noetic").controllers
    assert "starts no known robot: urdfctl smoke ROBOT --controllers " in result.reason
    assert result.reason.endswith("controllers.yaml")


def test_a_robot_with_a_missing_package_names_it(tmp_path: Path) -> None:
    include = '<xacro:include filename="$(find other)/a.xacro"/>'
    robot = f'<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">{include}</robot>'
    manifest = "<package><name>arm</name><depend>other</depend></package>"
    files = {"robot.xacro": robot, "controllers.yaml": CONTROLLERS, "package.xml": manifest}
    Folder(tmp_path).write(files)
    target = Target(str(tmp_path / "robot.xacro"), controllers=(str(tmp_path / "controllers.yaml"),))
    [result] = smoked(target, distro="noetic").controllers
    assert result.reason.startswith("not simulated: the robot needs package 'other', not here: clone it")


def test_a_robot_in_a_folder_of_tests_is_warned_unless_it_is_named(tmp_path: Path) -> None:
    files = {"robot.urdf": ROBOT.format(mass=MASS, plugin=PLUGIN), "controllers.yaml": CONTROLLERS}
    target = target_of(tmp_path / "test", files)
    made = smoked(target, distro="noetic")
    assert made.controllers[0].verdict is Verdict.FAILED
    aside = as_aside(PlannedTarget(target, TargetOrigin.FOUND), made)
    assert aside.controllers[0].verdict is Verdict.WARNED
    assert not aside.linted.outcome.has_errors
    assert as_aside(PlannedTarget(target, TargetOrigin.NAMED), made) == made
