"""What does no harm as the robot is used is info: a pose of zeros, a mass that only Gazebo misses, a part left out."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
CRANE = f"""<robot name="crane" xmlns:xacro="http://www.ros.org/wiki/xacro">{{}}
  <link name="mast"/>
  <joint name="slew" type="continuous"><parent link="mast"/><child link="jib"/><axis xyz="0 0 1"{{}}/></joint>
  <link name="jib">{MASS}</link>
  {{}}
</robot>"""
CONTROL = """<ros2_control name="crane" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="slew"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>"""
MANIFEST = "<package format='3'><name>crane</name><export><build_type>ament_cmake</build_type></export></package>"


def severities(folder: Folder, code: str) -> list[tuple[str, str]]:
    """Return the file and severity of each finding of a rule."""
    report = folder.run("lint", ".", "--no-cache", "--distro=jazzy", "--select", code, "--format", "json").stdout
    return [(finding["file"], finding["severity"]) for finding in json.loads(report)["findings"]]


@pytest.mark.parametrize(
    ("turn", "severity"), [("0 0 0", "info"), ("0.0 -0 +0.", "info"), ("", "info"), ("0 0 0.1", "warning")]
)
def test_an_attribute_that_would_change_nothing_is_info(folder: Folder, turn: str, severity: str) -> None:
    folder.write({"crane.urdf": CRANE.format("", f' rpy="{turn}"', "")})
    assert severities(folder, "UC163") == [("crane.urdf", severity)]


BARE = CRANE.replace(MASS, "")
SHOWN = """<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share crane)/crane.urdf')" type="str"/></node>
  <node pkg="rviz2" exec="rviz2"/>
</launch>"""


@pytest.mark.parametrize(
    ("files", "severity"),
    [
        ({}, "info"),
        ({"README.md": "Run `ros2 run gazebo_ros spawn_entity.py` to see it in Gazebo."}, "warning"),
        ({"crane.urdf": BARE.format("", "", CONTROL)}, "info"),
    ],
    ids=["nothing drives it", "a README speaks of Gazebo", "mocked hardware drives it"],
)
def test_a_link_without_mass_is_a_warning_only_if_gazebo_may_load_it(
    folder: Folder, files: dict[str, str], severity: str
) -> None:
    folder.write({"crane.urdf": BARE.format("", "", ""), "package.xml": MANIFEST, "launch/crane.launch.xml": SHOWN})
    folder.write(files)
    assert severities(folder, "UC133") == [("crane.urdf", severity)]


LAMP = """<xacro:arg name="lamp" default="false"/><xacro:property name="side" value="left"/>
  <xacro:if value="$(arg lamp)">
    <joint name="${side}_lamp_mount" type="fixed"><parent link="jib"/><child link="${side}_lamp"/></joint>
    <link name="${side}_lamp"/>
  </xacro:if>"""
COLOUR = '<gazebo reference="${{side}}_{}"><mu1>0.2</mu1></gazebo>'


@pytest.mark.parametrize(("name", "severity"), [("lamp", "info"), ("lamp_mount", "info"), ("lapm", "warning")])
def test_a_reference_to_a_link_that_a_condition_leaves_out_is_info(folder: Folder, name: str, severity: str) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format(LAMP, "", COLOUR.format(name))})
    assert severities(folder, "UC156") == [("crane.urdf.xacro", severity)]


def test_a_reference_whose_prefix_is_wrong_is_not_left_out_by_a_condition(folder: Folder) -> None:
    macro = """<xacro:macro name="lamp" params="side">
    <joint name="${side}_mount" type="fixed"><parent link="jib"/><child link="${side}_lamp"/></joint>
    <link name="${side}_lamp"/></xacro:macro><xacro:lamp side="left"/><xacro:property name="side" value="rear"/>"""
    folder.write({"crane.urdf.xacro": CRANE.format(macro, "", COLOUR.format("lamp"))})
    assert severities(folder, "UC156") == [("crane.urdf.xacro", "warning")]


ELSEWHERE = """<joint name="mount" type="fixed"><parent link="jib"/><child link="lamp"/></joint>
  <link name="lamp"><visual><geometry><mesh filename="package://lamp_description/lamp.stl"/></geometry></visual></link>"""
INCLUDED = '<xacro:include filename="$(find lamp_description)/lamp.xacro"/>'


@pytest.mark.parametrize(
    ("name", "text", "severity"),
    [
        (
            "crane.repos",
            "repositories: {lamps: {type: git, url: 'https://example.com/acme/lamp_description.git'}}",
            "info",
        ),
        ("README.md", "First `git clone git@example.com:acme/lamp_description`.", "info"),
        ("setup.sh", "sudo apt-get install -y ros-noetic-lamp-description", "info"),
        ("README.md", "The lamp is in lamp_description.", "warning"),
        ("README.md", "git clone https://example.com/acme/lamp_description_old", "warning"),
    ],
)
@pytest.mark.parametrize(("code", "part"), [("UC150", ELSEWHERE), ("UC003", INCLUDED)])
def test_a_package_that_the_workspace_says_how_to_get_is_info(
    folder: Folder, code: str, part: str, name: str, text: str, severity: str
) -> None:
    folder.write({"crane.urdf.xacro": CRANE.format("", "", part), "package.xml": MANIFEST, name: text})
    assert severities(folder, code) == [("crane.urdf.xacro", severity)]


def test_what_rosmon_reads_of_a_node_is_not_an_unknown_attribute(folder: Folder) -> None:
    node = '<launch><node name="n" pkg="crane" type="hoist" {}="5"/></launch>'
    folder.write({"launch/hoist.launch": node.format("rosmon-stop-timeout"), "package.xml": MANIFEST})
    folder.write({"launch/other.launch": node.format("stop-timeout"), "crane.urdf": CRANE.format("", "", "")})
    told = folder.run("lint", "launch/hoist.launch", "launch/other.launch", "--select=UC038", "--format=concise").stdout
    assert "hoist.launch" not in told
    assert "<node> has no attribute 'stop-timeout'" in told


def test_an_included_launch_file_that_only_ends_in_xml_is_not_read_as_a_robot(folder: Folder) -> None:
    outer = '<launch><include ns="move_group" file="$(find crane)/launch/planner.xml"/>{}</launch>'
    outer = outer.format('<node name="move_group" pkg="moveit_ros_move_group" type="move_group"/>')
    folder.write(
        {
            "package.xml": "<package><name>crane</name></package>",
            "launch/crane.launch": outer,
            "crane.urdf": CRANE.format("", "", ""),
        }
    )
    folder.write({"launch/planner.xml": '<launch><param name="a" value="1"/></launch>'})
    assert "UC101" not in folder.run("lint", ".", "--no-cache", "--select=UC101").stdout
