"""Controllers that a launch file writes in a <rosparam>: they move to a file."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import arm, migrated, transmission

PLUGIN = (
    '<gazebo><plugin name="c" filename="libgazebo_ros_control.so">'
    "<robotNamespace>/{}</robotNamespace></plugin></gazebo>\n"
)
LAUNCH = """<launch>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/arm.xacro"/>
  <node name="put" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
  {}
    ctl:
      type: effort_controllers/JointEffortController
      joint: shoulder
  </rosparam>
  <node name="spawn" pkg="controller_manager" type="spawner" {} args="ctl"/>
</launch>
"""
FILE = "config/a_controllers.yaml"


def moved(folder: Folder, opened: str, space: str = "", **more: str) -> dict[str, str]:
    robot = arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN.format(space))
    launch = LAUNCH.format(opened, f'ns="{space}"' if space else "")
    return migrated(folder, {"arm.xacro": robot, "launch/a.launch": launch, **more})


def test_the_plugin_and_the_spawner_get_the_file_of_inline_controllers(folder: Folder) -> None:
    after = moved(folder, "<rosparam>")
    assert "ctl:\n  ros__parameters:\n    joints: [shoulder]" in after[FILE]
    assert f"<parameters>$(find arm)/{FILE}</parameters>" in after["arm.xacro"]
    assert f'"--param-file", [FindPackageShare("arm"), "/{FILE}"]' in " ".join(after["launch/a.launch.py"].split())


@pytest.mark.parametrize("opened", ['<rosparam ns="cell">', '<rosparam param="cell">'])
def test_inline_controllers_keep_their_namespace(folder: Folder, opened: str) -> None:
    after = moved(folder, opened, space="cell")
    assert "/cell/controller_manager:" in after[FILE]
    assert "/cell/ctl:" in after[FILE]


def test_an_argument_in_inline_controllers_has_its_value(folder: Folder) -> None:
    launch = '<arg name="which" default="shoulder"/>\n  <rosparam subst_value="true">'
    robot = arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN.format(""))
    text = LAUNCH.format(launch, "").replace("joint: shoulder", "joint: $(arg which)")
    after = migrated(folder, {"arm.xacro": robot, "launch/a.launch": text})
    assert "joints: [shoulder]" in after[FILE]


def test_a_file_that_is_there_is_not_replaced(folder: Folder) -> None:
    after = moved(folder, "<rosparam>", **{FILE: "other: 1\n"})
    assert after[FILE] == "other: 1\n"
    assert "ctl:" in after["config/a_controllers_2.yaml"]


def test_parameters_that_are_no_controllers_stay(folder: Folder) -> None:
    launch = LAUNCH.format("<rosparam>", "").replace("type: effort_controllers/JointEffortController", "gain: 1.0")
    after = migrated(folder, {"launch/a.launch": launch})
    assert FILE not in after


TWO = """<launch>
  <include file="$(find arm)/launch/part.launch"><arg name="side" value="left"/></include>
  <include file="$(find arm)/launch/part.launch"><arg name="side" value="right"/></include>
</launch>
"""
PART = """<launch>
  <arg name="side"/>
  <param name="$(arg side)/robot_description" command="$(find xacro)/xacro $(find arm)/arm.xacro"/>
  <rosparam file="$(find arm)/config/{}.yaml" ns="$(arg side)"/>
  <node name="spawn" pkg="controller_manager" type="spawner" ns="$(arg side)" args="ctl"/>
</launch>
"""


@pytest.mark.parametrize(("chosen", "space"), [("$(arg side)", "/left"), ("left", '"/**')])
def test_a_file_that_the_argument_of_its_namespace_chooses_is_for_that_namespace(
    folder: Folder, chosen: str, space: str
) -> None:
    robot = arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN.format("$(arg side)"))
    controllers = "ctl:\n  type: effort_controllers/JointEffortController\n  joint: shoulder\n"
    files = {"config/left.yaml": controllers, "config/right.yaml": controllers}
    launches = {"launch/a.launch": TWO, "launch/part.launch": PART.format(chosen)}
    after = migrated(folder, {"arm.xacro": robot, **files, **launches})
    assert after["config/left.yaml"].startswith(f"{space}/controller_manager")


@pytest.mark.parametrize("given", ["--time 30 --stop", "--timeout=30 --stopped", "--shut 5 --timeo 30 --stopp"])
def test_options_of_a_spawner_are_read_as_argparse_reads_them(folder: Folder, given: str) -> None:
    robot = arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN.format(""))
    launch = LAUNCH.format("<rosparam>", "").replace('args="ctl"', f'args="ctl {given}"')
    after = migrated(folder, {"arm.xacro": robot, "launch/a.launch": launch})
    text = " ".join(after["launch/a.launch.py"].split())
    assert '"ctl", "--controller-manager-timeout", "30", "--inactive"' in text
    assert "--shut" not in text
