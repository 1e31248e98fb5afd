"""Faults that stop what a launch file starts: texts read as YAML, empty files, namespaces, missing folders."""

from __future__ import annotations

from pathlib import Path

import pytest
from robots import findings, whole

from urdfctl.load.target import Target
from urdfctl.source.workspaces.install_maps import missing_sources

_PYTHON = """
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue

def generate_launch_description():
    described = {'robot_description': TEXT}
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[described]),
        Node(package='controller_manager', executable='ros2_control_node', parameters=[FILE]),
        Node(package='controller_manager', executable='spawner', arguments=['arm_controller']),
    ])
"""


def _write(folder: Path, **files: str) -> Path:
    (folder / "package.xml").write_text("<package format='3'><name>arm</name></package>", encoding="utf-8")
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text, encoding="utf-8")
    return folder


def _lint(folder: Path, launch: str, *codes: str, distro: str) -> list[str]:
    found = findings(Target(str(folder / launch)), codes, workspace=str(folder), distro=distro)
    return [f"{finding.severity.value} {finding.code} {Path(finding.at.file).name}" for finding in found]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Command(['xacro ', PATH])", ["error UC632 arm.launch.py"]),
        ("ParameterValue(Command(['xacro ', PATH]))", ["error UC632 arm.launch.py"]),
        ("ParameterValue(Command(['xacro ', PATH]), value_type=str)", []),
        ("open(PATH).read()", []),
    ],
)
def test_a_description_without_a_type_is_read_as_yaml(text: str, expected: list[str], tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    launch = _PYTHON.replace("TEXT", text).replace("PATH", repr(str(path))).replace("FILE", "{}")
    _write(tmp_path, arm__urdf=whole("arm.urdf", "<!-- note: by hand -->"), arm__launch__py=launch)
    assert _lint(tmp_path, "arm.launch.py", "UC632", distro="humble") == expected


def test_a_controller_spawned_from_an_empty_file_is_unknown(tmp_path: Path) -> None:
    launch = _PYTHON.replace("TEXT", f"open({str(tmp_path / 'arm.urdf')!r}).read()")
    launch = launch.replace("FILE", repr(str(tmp_path / "controllers.yaml")))
    _write(tmp_path, arm__urdf=whole("arm.urdf", ""), controllers__yaml="", arm__launch__py=launch)
    assert _lint(tmp_path, "arm.launch.py", "UC601", distro="humble") == ["error UC601 controllers.yaml"]


@pytest.mark.parametrize(
    ("words", "namespace", "expected"),
    [
        ("-model arm", "arm", ["error UC525 arm.launch"]),
        ("-model arm -robot_namespace /arm", "arm", []),
        ("-model arm", "", []),
    ],
)
def test_a_plugin_without_a_namespace_takes_that_of_the_node_that_spawns_the_model(
    words: str, namespace: str, expected: list[str], tmp_path: Path
) -> None:
    plugin = "<gazebo><plugin name='control' filename='libgazebo_ros_control.so'/></gazebo>"
    launch = f"""
        <launch>
          <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
          <node name="model" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description {words}"/>
          <node name="spawner" pkg="controller_manager" type="spawner" ns="{namespace}" args="states"/>
        </launch>
    """
    _write(tmp_path, arm__urdf=whole("arm.urdf", plugin), arm__launch=launch)
    assert _lint(tmp_path, "arm.launch", "UC525", distro="noetic") == expected


def test_a_folder_of_a_package_is_no_package(tmp_path: Path) -> None:
    mesh = '<link name="tool"><visual><geometry><mesh filename="package://meshes/tool.stl"/></geometry></visual></link>'
    _write(tmp_path, arm__urdf=whole("arm.urdf", mesh))
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "tool.stl").write_text("", encoding="utf-8")
    [found] = findings(tmp_path / "arm.urdf", ("UC150",), workspace=str(tmp_path))
    assert found.message == "'meshes' is not a package, but a folder of package 'arm'"
    assert found.fix is not None
    assert [edit.text for edit in found.fix.edits] == ["package://arm/meshes/tool.stl"]


@pytest.mark.parametrize(
    ("cmake", "missing"),
    [
        ("install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})", ["launch"]),
        ('install(DIRECTORY "launch" DESTINATION share/arm)', ["launch"]),
        ("install(DIRECTORY launch DESTINATION share/arm OPTIONAL)", []),
        ("if(BUILD_TESTING)\n  install(DIRECTORY test DESTINATION share/arm)\nendif()", []),
        ("# install(DIRECTORY launch DESTINATION share/arm)", []),
        ("install(DIRECTORY ${FOLDERS} DESTINATION share/arm)", []),
        ("configure_file(a.in launch)\ninstall(DIRECTORY launch DESTINATION share/arm)", []),
        ("install(TARGETS arm DESTINATION lib)", []),
        ("install(PROGRAMS scripts/go.py DESTINATION lib/arm)", ["scripts/go.py"]),
    ],
)
def test_literal_sources_of_install_rules_must_exist(cmake: str, missing: list[str], tmp_path: Path) -> None:
    (tmp_path / "config").mkdir()
    found = list(missing_sources(cmake, str(tmp_path), "arm"))
    assert [name for name, _ in found] == missing
    assert all(cmake[start:].startswith(name) for name, start in found)


def test_controllers_are_checked_although_the_spawner_names_another_one(tmp_path: Path) -> None:
    part = """
        <transmission name="elbow_trans">
          <type>transmission_interface/SimpleTransmission</type>
          <joint name="elbow"><hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint>
          <actuator name="elbow_motor"><mechanicalReduction>1</mechanicalReduction></actuator>
        </transmission>
        <gazebo><plugin name="control" filename="libgazebo_ros_control.so"/></gazebo>
    """
    launch = """
        <launch>
          <param name="robot_description" textfile="$(find arm)/arm.urdf"/>
          <rosparam command="load" file="$(find arm)/controllers.yaml"/>
          <node name="spawner" pkg="controller_manager" type="spawner" args="arm_controller"/>
        </launch>
    """
    controllers = "elbow_controller: {type: effort_controllers/JointEffortController, joint: elbow}"
    _write(tmp_path, arm__urdf=whole("arm.urdf", part), arm__launch=launch, controllers__yaml=controllers)
    assert "UC461" in " ".join(_lint(tmp_path, "arm.launch", "UC461", "UC601", distro="noetic"))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Command(['xacro ', PATH])", ["error UC632 arm.launch.py"]),
        ("ParameterValue(Command(['xacro ', PATH]), value_type=str)", []),
    ],
)
def test_an_srdf_without_a_type_is_read_as_yaml(text: str, expected: list[str], tmp_path: Path) -> None:
    launch = _PYTHON.replace("TEXT", f"open({str(tmp_path / 'arm.urdf')!r}).read()").replace("FILE", "{}")
    semantic = text.replace("PATH", repr(str(tmp_path / "arm.srdf")))
    parameters = f"[described, {{'robot_description_semantic': {semantic}}}]"
    group = f"Node(package='moveit_ros_move_group', executable='move_group', parameters={parameters}),"
    launch = launch.replace("LaunchDescription([", f"LaunchDescription([\n        {group}")
    srdf = "<robot name='arm'><!-- GROUPS: the arm --><group name='arm'><joint name='elbow'/></group></robot>"
    _write(tmp_path, arm__urdf=whole("arm.urdf", ""), arm__srdf=srdf, arm__launch__py=launch)
    assert _lint(tmp_path, "arm.launch.py", "UC632", distro="humble") == expected


def test_a_manager_beside_that_of_the_simulator_has_the_same_name(tmp_path: Path) -> None:
    part = """
        <ros2_control name="arm" type="system">
          <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
          <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
        </ros2_control>
        <gazebo>
          <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
            <parameters>/opt/arm.yaml</parameters>
          </plugin>
        </gazebo>
    """
    launch = """
        <launch>
          <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>
          <node pkg="robot_state_publisher" exec="robot_state_publisher">
            <param name="robot_description" value="$(command 'xacro $(find-pkg-share arm)/arm.urdf')" type="str"/>
          </node>
          <node pkg="controller_manager" exec="ros2_control_node"/>
        </launch>
    """
    _write(tmp_path, arm__urdf=whole("arm.urdf", part), arm__launch__xml=launch)
    assert _lint(tmp_path, "arm.launch.xml", "UC607", distro="jazzy") == ["warning UC607 arm.launch.xml"]
