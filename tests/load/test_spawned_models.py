"""A robot that is spawned from an SDF file has the plugin of that file, and the controllers that the plugin names."""

from __future__ import annotations

import json

from folder import Folder

MANIFEST = "<package format='3'><name>crab</name><export><build_type>ament_cmake</build_type></export></package>"
ROBOT = """<robot name="crab">
  <link name="body"/>
  <joint name="claw" type="revolute"><parent link="body"/><child link="pincer"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="3" velocity="1"/></joint>
  <link name="pincer"/>
  <ros2_control name="claws" type="system">
    <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
    <joint name="claw"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>"""
HOST = """<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
      <parameters>/home/somebody/ws/src/crab/config/claws.yaml</parameters></plugin>"""
SDF = "<sdf version='1.9'><model name='crab'><link name='body'/>{}</model></sdf>"
CLAWS = """controller_manager:
  ros__parameters:
    pinch: {type: forward_command_controller/ForwardCommandController}
pinch:
  ros__parameters: {joints: [claw], interface_name: position}
"""
LAUNCH = """<launch>
  <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py">
    <arg name="gz_args" value="-r empty.sdf"/></include>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'cat $(find-pkg-share crab)/urdf/crab.urdf')" type="str"/></node>
  <node pkg="ros_gz_sim" exec="create" args="-file {} -name crab"/>
  <node pkg="controller_manager" exec="spawner" args="pinch"/>
</launch>"""
MODEL = "$(find-pkg-share crab)/models/crab.sdf"


def findings(folder: Folder, model: str = MODEL, robot: str = ROBOT, **models: str) -> tuple[list[str], list[str]]:
    """The codes about the plugin, and the files of controllers that belong to the robot."""
    folder.write(
        {
            "package.xml": MANIFEST,
            "urdf/crab.urdf": robot,
            "config/claws.yaml": CLAWS,
            "config/spare.yaml": CLAWS,
            "launch/sea.launch.xml": LAUNCH.format(model),
            **{f"models/{name}.sdf": text for name, text in models.items()},
        }
    )
    found = json.loads(folder.run("lint", ".", "--distro", "jazzy", "--format", "json").stdout)
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    codes = [each["code"] for each in found["findings"] if each["code"] in {"UC508", "UC509", "UC601"}]
    return codes, [each for target in shown["targets"] if target["launch"] for each in target["controllers"]]


def test_the_plugin_of_the_model_loads_its_controllers(folder: Folder) -> None:
    assert findings(folder, crab=SDF.format(HOST)) == ([], ["config/claws.yaml"])


def test_a_model_without_the_plugin_has_no_controllers(folder: Folder) -> None:
    codes, controllers = findings(folder, crab=SDF.format(""))
    assert "UC508" in codes
    assert controllers == []


def test_a_model_that_was_made_from_the_description_has_its_plugin_once(folder: Folder) -> None:
    robot = ROBOT.replace("</robot>", f"<gazebo>{HOST}</gazebo></robot>")
    assert findings(folder, robot=robot, crab=SDF.format(HOST)) == ([], ["config/claws.yaml"])


def test_a_scene_beside_the_robot_changes_nothing(folder: Folder) -> None:
    codes, controllers = findings(folder, "$(find-pkg-share crab)/urdf/crab.urdf", reef=SDF.format(HOST))
    assert "UC508" in codes
    assert controllers == []


def test_a_model_that_only_the_simulator_finds_may_have_the_plugin(folder: Folder) -> None:
    assert "UC508" not in findings(folder, "model://crab")[0]


def test_a_model_that_is_broken_is_as_one_that_is_not_read(folder: Folder) -> None:
    assert findings(folder, crab="<sdf><model>")[1] == []
