"""MoveIt's files: which ones a launch file gives to MoveIt, what an SRDF says, and how its groups are made."""

from __future__ import annotations

from pathlib import Path

import pytest
from robots import findings, whole

from urdfctl.config.settings import Settings
from urdfctl.control.groups import Groups
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.moveit import MoveIt

_FINGERS = """
    <link name="left"/><link name="right"/><link name="tip"/>
    <joint name="left_joint" type="prismatic">
      <parent link="fore"/><child link="left"/><limit lower="0" upper="1" effort="1" velocity="1"/>
    </joint>
    <joint name="right_joint" type="prismatic">
      <parent link="fore"/><child link="right"/><limit lower="0" upper="1" effort="1" velocity="1"/>
      <mimic joint="left_joint"/>
    </joint>
    <joint name="tool" type="fixed"><parent link="fore"/><child link="tip"/></joint>
"""


def _write(folder: Path, files: dict[str, str]) -> None:
    (folder / "package.xml").write_text("<package format='3'><name>arm</name></package>", encoding="utf-8")
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(whole(name, text) if name.endswith(".urdf") else text, encoding="utf-8")


def _moveit(folder: Path, target: str) -> MoveIt:
    moveit = Loader(Settings(workspace=str(folder))).load(Target(str(folder / target))).project.moveit
    assert moveit is not None
    return moveit


def _groups(folder: Path, groups: str, part: str = _FINGERS) -> Groups:
    _write(folder, {"arm.urdf": part, "arm.srdf": f'<robot name="arm">{groups}</robot>'})
    project = Loader(Settings(workspace=str(folder))).load(Target(str(folder / "arm.urdf"))).project
    assert project.robot is not None
    assert project.moveit is not None
    assert project.moveit.semantic is not None
    return Groups(project.robot, project.moveit.semantic)


# -- groups ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("group", "is_chain", "active"),
    [
        ('<chain base_link="base" tip_link="fore"/>', True, ["elbow", "shoulder"]),
        ('<chain base_link="world" tip_link="tip"/>', True, ["elbow", "shoulder"]),
        ('<joint name="shoulder"/><joint name="elbow"/>', True, ["elbow", "shoulder"]),
        ('<link name="upper"/><link name="fore"/><link name="tip"/>', True, ["elbow", "shoulder"]),
        ('<link name="world"/><joint name="shoulder"/>', True, ["shoulder"]),
        ('<joint name="shoulder"/><joint name="left_joint"/>', False, ["left_joint", "shoulder"]),
        ('<joint name="left_joint"/><joint name="right_joint"/>', False, ["left_joint"]),
        ('<joint name="tool"/>', False, []),
        ('<chain base_link="left" tip_link="tip"/>', False, ["left_joint"]),
        ('<group name="inner"/>', True, ["elbow"]),
    ],
)
def test_a_group_is_a_chain_if_each_joint_is_right_below_the_one_before(
    group: str, is_chain: bool, active: list[str], tmp_path: Path
) -> None:
    inner = '<group name="inner"><joint name="elbow"/></group>'
    groups = _groups(tmp_path, f'<group name="g">{group}</group>{inner}')
    of_name = groups.semantic.group("g")
    assert of_name is not None
    assert groups.is_chain(of_name) is is_chain
    assert groups.active(of_name) == active


def test_a_group_that_contains_itself_has_its_own_joints(tmp_path: Path) -> None:
    groups = _groups(tmp_path, '<group name="g"><joint name="elbow"/><group name="g"/></group>')
    assert groups.active(groups.semantic.groups[0]) == ["elbow"]


@pytest.mark.parametrize(
    ("virtual", "is_chain"),
    [
        ('<virtual_joint name="v" type="planar" parent_frame="odom" child_link="world"/>', True),
        ('<virtual_joint name="v" type="fixed" parent_frame="odom" child_link="base"/>', True),
        ('<virtual_joint name="v" type="planar" parent_frame="odom" child_link="base"/>', True),
        ("", True),
    ],
)
def test_a_virtual_joint_is_the_joint_above_the_root_link(virtual: str, is_chain: bool, tmp_path: Path) -> None:
    group = '<group name="g"><joint name="v"/><joint name="shoulder"/></group>'
    groups = _groups(tmp_path, virtual + group)
    assert groups.is_chain(groups.semantic.groups[0]) is is_chain
    assert groups.active(groups.semantic.groups[0]) == ["shoulder"]


# -- launch files ----------------------------------------------------------------------------------------------------

_BUILDER = """
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_demo_launch, generate_move_group_launch


def generate_launch_description():
    config = MoveItConfigsBuilder("arm", package_name="arm")CALLS.to_moveit_configs()
    return generate_LAUNCH_launch(config)
"""
_SEMANTIC = '<robot name="arm"><group name="arm"><joint name="elbow"/></group></robot>'
_KINEMATICS = "arm: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}"
_CONTROLLERS = """
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm_controller: {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [elbow]}
"""
_CONFIG = {
    "config/arm.urdf.xacro": whole("arm.urdf.xacro", "<!-- part -->"),
    "config/arm.srdf": _SEMANTIC,
    "config/kinematics.yaml": _KINEMATICS,
    "config/joint_limits.yaml": "joint_limits: {elbow: {has_velocity_limits: false}}",
    "config/moveit_controllers.yaml": _CONTROLLERS,
    "config/ros2_controllers.yaml": "controller_manager: {ros__parameters: {update_rate: 100}}",
    "config/ompl_planning.yaml": "planning_plugin: ompl_interface/OMPLPlanner",
}


@pytest.mark.parametrize(
    ("launch", "plugin", "expected"),
    [
        ("demo", "gz_ros2_control/GazeboSimSystem", ["UC607"]),
        ("demo", "mock_components/GenericSystem", []),
        ("move_group", "gz_ros2_control/GazeboSimSystem", []),
    ],
)
def test_the_manager_of_a_demo_cannot_load_simulated_hardware(
    launch: str, plugin: str, expected: list[str], tmp_path: Path
) -> None:
    hardware = f"""<ros2_control name="arm" type="system"><hardware><plugin>{plugin}</plugin></hardware>
        <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
    </ros2_control>"""
    text = _BUILDER.replace("CALLS", "").replace("LAUNCH", launch)
    robot = whole("arm.urdf.xacro", hardware)
    _write(tmp_path, {**_CONFIG, "config/arm.urdf.xacro": robot, "demo.launch.py": text})
    found = findings(tmp_path / "demo.launch.py", ("UC607",), workspace=str(tmp_path), distro="jazzy")
    assert [each.code for each in found] == expected


@pytest.mark.parametrize("launch", ["demo", "move_group"])
def test_a_builder_reads_the_usual_files_of_its_package(launch: str, tmp_path: Path) -> None:
    _write(tmp_path, {**_CONFIG, "demo.launch.py": _BUILDER.replace("CALLS", "").replace("LAUNCH", launch)})
    moveit = _moveit(tmp_path, "demo.launch.py")
    assert moveit.semantic is not None
    assert [group.name.text for group in moveit.semantic.groups] == ["arm"]
    assert [solver.group.text for solver in moveit.solvers] == ["arm"]
    assert [limits.joint.text for limits in moveit.limits] == ["elbow"]
    assert [controller.name.text for controller in moveit.controllers] == ["arm_controller"]
    assert [pipeline.name for pipeline in moveit.pipelines] == ["ompl"]


def test_calls_of_a_builder_name_other_files(tmp_path: Path) -> None:
    calls = """.robot_description_semantic(file_path="config/other.srdf").trajectory_execution("config/c.yaml")"""
    other = _SEMANTIC.replace('group name="arm"', 'group name="other"')
    files = {"config/other.srdf": other, "config/c.yaml": _CONTROLLERS.replace("arm_controller", "mine")}
    launch = _BUILDER.replace("CALLS", calls).replace("LAUNCH", "move_group")
    _write(tmp_path, {**_CONFIG, **files, "demo.launch.py": launch})
    moveit = _moveit(tmp_path, "demo.launch.py")
    assert moveit.semantic is not None
    assert [group.name.text for group in moveit.semantic.groups] == ["other"]
    assert [controller.name.text for controller in moveit.controllers] == ["mine"]


def test_the_setup_assistant_says_where_the_description_and_the_srdf_are(tmp_path: Path) -> None:
    setup = """
moveit_setup_assistant_config:
  urdf: {package: arm, relative_path: urdf/robot.urdf, xacro_args: ""}
  srdf: {relative_path: config/plan.srdf}
"""
    kept = {name: text for name, text in _CONFIG.items() if name.endswith(".yaml")}
    launch = _BUILDER.replace("CALLS", "").replace("LAUNCH", "move_group")
    files = {".setup_assistant": setup, "config/plan.srdf": _SEMANTIC, "urdf/robot.urdf": "<!-- part -->"}
    _write(tmp_path, {**kept, **files, "demo.launch.py": launch})
    loaded = Loader(Settings(workspace=str(tmp_path))).load(Target(str(tmp_path / "demo.launch.py")))
    assert loaded.project.path == str(tmp_path / "urdf/robot.urdf")
    assert loaded.project.moveit is not None
    assert loaded.project.moveit.semantic is not None


def test_the_dicts_of_a_node_are_followed_to_their_files(tmp_path: Path) -> None:
    launch = """
import os
import yaml
from launch import LaunchDescription
from launch_ros.actions import Node

def load(name):
    with open(os.path.join(FOLDER, name)) as file:
        return yaml.safe_load(file)

def generate_launch_description():
    semantic = {'robot_description_semantic': open(os.path.join(FOLDER, 'arm.srdf')).read()}
    kinematics = {'robot_description_kinematics': load('kinematics.yaml')}
    controllers = {'moveit_simple_controller_manager': load('names.yaml')}
    pipeline = {'ompl': load('ompl_planning.yaml')}
    parameters = [semantic, kinematics, controllers, pipeline]
    return LaunchDescription([Node(package='moveit_ros_move_group', executable='move_group', parameters=parameters)])
"""
    names = "controller_names: [mine]\nmine: {type: FollowJointTrajectory, action_ns: a, joints: [elbow]}"
    launch = launch.replace("FOLDER", repr(str(tmp_path / "config")))
    _write(tmp_path, {**_CONFIG, "config/names.yaml": names, "group.launch.py": launch})
    moveit = _moveit(tmp_path, "group.launch.py")
    assert moveit.semantic is not None
    assert [solver.group.text for solver in moveit.solvers] == ["arm"]
    assert [controller.name.text for controller in moveit.controllers] == ["mine"]
    assert [pipeline.name for pipeline in moveit.pipelines] == ["ompl"]


def test_ros1_loads_the_files_into_the_namespace_of_the_description(tmp_path: Path) -> None:
    launch = """
      <launch>
        <group ns="left">
          <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
          <param name="robot_description_semantic" textfile="$(find arm)/config/arm.srdf"/>
          <group ns="robot_description_kinematics">
            <rosparam command="load" file="$(find arm)/config/kinematics.yaml"/>
          </group>
          <group ns="robot_description_planning">
            <rosparam command="load" file="$(find arm)/config/joint_limits.yaml"/>
          </group>
          <node name="move_group" pkg="moveit_ros_move_group" type="move_group">
            <rosparam command="load" file="$(find arm)/config/list.yaml"/>
          </node>
        </group>
      </launch>
    """
    listed = "controller_list: [{name: mine, action_ns: a, type: FollowJointTrajectory, joints: [elbow]}]"
    _write(tmp_path, {**_CONFIG, "arm.urdf": "<!-- part -->", "config/list.yaml": listed, "left.launch": launch})
    moveit = _moveit(tmp_path, "left.launch")
    assert moveit.semantic is not None
    assert [solver.group.text for solver in moveit.solvers] == ["arm"]
    assert [limits.joint.text for limits in moveit.limits] == ["elbow"]
    assert [controller.name.text for controller in moveit.controllers] == ["mine"]


# -- rules -----------------------------------------------------------------------------------------------------------


def _said(folder: Path, **options: str) -> list[str]:
    found = findings(folder / "arm.urdf", ("UC65", "UC66", "UC67"), workspace=str(folder), **options)
    return [f"{finding.severity.value} {finding.code} {finding.at.line}:{finding.at.column}" for finding in found]


def test_an_srdf_of_another_robot_is_reported_once(tmp_path: Path) -> None:
    groups = "".join(f'<group name="g{n}"><joint name="joint_{n}"/></group>' for n in range(5))
    _write(tmp_path, {"arm.urdf": "<!-- part -->", "arm.srdf": f'<robot name="other">{groups}</robot>'})
    assert _said(tmp_path) == ["error UC657 1:14"]


def test_a_srdf_that_is_not_complete_is_not_judged(tmp_path: Path) -> None:
    include = '<xacro:include filename="$(find other)/groups.xacro"/>'
    namespace = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    semantic = f'<robot name="arm" {namespace}>{include}<group_state name="home" group="gone"/></robot>'
    _write(tmp_path, {"arm.urdf": "<!-- part -->", "arm.srdf": semantic})
    assert _said(tmp_path) == []


def test_an_srdf_that_is_not_xml_is_left_alone(tmp_path: Path) -> None:
    _write(tmp_path, {"arm.urdf": "<!-- part -->", "arm.srdf": "<robot name='arm'><group"})
    assert _said(tmp_path) == []


@pytest.mark.parametrize(
    ("distro", "pipeline", "expected"),
    [
        ("jazzy", "planning_plugin: p", ["error UC670 1:1"]),
        ("jazzy", "planning_plugins: [p]\nrequest_adapters: a b", ["error UC670 2:1"]),
        ("humble", "planning_plugins: [p]", ["error UC670 1:1"]),
        ("humble", "planning_plugin: p\nrequest_adapters: [a, b]", ["error UC670 2:1"]),
        ("humble", "planning_plugin: p\nrequest_adapters: a b", []),
        ("noetic", "planning_plugin: p", []),
    ],
)
def test_a_pipeline_is_written_for_a_distro(distro: str, pipeline: str, expected: list[str], tmp_path: Path) -> None:
    _write(tmp_path, {"arm.urdf": "<!-- part -->", "arm.srdf": _SEMANTIC, "ompl_planning.yaml": pipeline})
    assert _said(tmp_path, distro=distro) == expected


@pytest.mark.parametrize(
    ("entry", "expected"),
    [
        ("name: mine, action_ns: a, joints: [shoulder, elbow]", ["error UC651 1:26"]),
        ("name: mine, ns: a, joints: [shoulder, elbow]", []),
        ("name: fake_mine, joints: [shoulder, elbow], type: interpolate", []),
        ("", ["warning UC655 1:1"]),
    ],
)
def test_entries_of_controller_list_need_a_type_and_an_action(entry: str, expected: list[str], tmp_path: Path) -> None:
    launch = """
      <launch>
        <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
        <param name="robot_description_semantic" textfile="$(find arm)/arm.srdf"/>
        <rosparam command="load" ns="move_group" file="$(find arm)/list.yaml"/>
      </launch>
    """
    items = f"{{{entry}}}" if entry else ""
    files = {"arm.urdf": "<!-- part -->", "arm.srdf": _SEMANTIC, "list.yaml": f"controller_list: [{items}]"}
    _write(tmp_path, {**files, "arm.launch": launch})
    found = findings(Target(str(tmp_path / "arm.launch")), ("UC65",), workspace=str(tmp_path), distro="noetic")
    assert [f"{one.severity.value} {one.code} {one.at.line}:{one.at.column}" for one in found] == expected


def test_a_builder_needs_the_usual_files(tmp_path: Path) -> None:
    kept = {name: text for name, text in _CONFIG.items() if "kinematics" not in name}
    _write(tmp_path, {**kept, "demo.launch.py": _BUILDER.replace("CALLS", "").replace("LAUNCH", "demo")})
    found = findings(Target(str(tmp_path / "demo.launch.py")), ("UC676",), workspace=str(tmp_path), distro="humble")
    assert [one.message for one in found] == ["kinematics file for MoveIt does not exist: 'config/kinematics.yaml'"]


def test_groups_that_contain_each_other_end(tmp_path: Path) -> None:
    names = [f"g{number}" for number in range(40)]
    inner = "".join(f'<group name="{name}"/>' for name in names)
    groups = _groups(tmp_path, "".join(f'<group name="{name}">{inner}<joint name="elbow"/></group>' for name in names))
    assert {tuple(groups.active(group)) for group in groups.semantic.groups} == {("elbow",)}
