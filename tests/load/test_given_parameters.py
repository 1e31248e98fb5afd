"""What a launch file itself says about controllers: dicts of a node, parameters of ROS 1 in XML, rewritten files."""

from __future__ import annotations

import json

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>p</name><export><build_type>ament_cmake</build_type></export></package>"
ROBOT = (
    "<robot name='r'><link name='a'/><link name='b'/><joint name='pan' type='continuous'><parent link='a'/><child "
    "link='b'/></joint><ros2_control name='s' type='system'><hardware><plugin>mock_components/GenericSystem</plugin>"
    "</hardware><joint name='pan'><command_interface name='position'/><state_interface name='position'/></joint>"
    "</ros2_control></robot>"
)
LAUNCH = """
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from nav2_common.launch import ReplaceString, RewrittenYaml


def generate_launch_description():
    share = get_package_share_directory("p")
    robot = Command(["cat ", os.path.join(share, "r.urdf")])
    file = os.path.join(share, "c.yaml")
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher", namespace="NAMESPACE",
             parameters=[{"robot_description": robot}]),
        Node(package="controller_manager", executable="ros2_control_node", namespace="NAMESPACE",
             parameters=[{"robot_description": robot}, PARAMETERS]),
        Node(package="controller_manager", executable="spawner", namespace="NAMESPACE", arguments=["turn"]),
    ])
"""
FORWARD = "forward_command_controller/ForwardCommandController"
SECTIONS = "controller_manager:\n  ros__parameters:\n    turn: {type: %s}\n"
SECTIONS += "turn:\n  ros__parameters: {joints: [JOINT], interface_name: position}\n"


def found(folder: Folder, parameters: str, namespace: str = "", file: str = SECTIONS % FORWARD) -> list[str]:
    """The errors of a robot whose controller manager gets some parameters."""
    launch = LAUNCH.replace("PARAMETERS", parameters).replace("NAMESPACE", namespace)
    folder.write({"package.xml": MANIFEST, "r.urdf": ROBOT, "launch/r.launch.py": launch, "c.yaml": file})
    ran = folder.run("lint", "launch/r.launch.py", "--distro", "jazzy", "--format", "json", "--exit-zero")
    return [f"{one['code']} {one['line']}" for one in json.loads(ran.stdout)["findings"] if one["severity"] == "error"]


@pytest.mark.parametrize(
    "types",
    [
        f'{{"turn.type": "{FORWARD}"}}',
        f'{{"turn": {{"type": "{FORWARD}", "joints": ["JOINT"], "interface_name": "position"}}}}',
        f'file, {{"update_rate": 50, "turn.type": "{FORWARD}"}}',
    ],
)
@pytest.mark.parametrize(("joint", "is_wrong"), [("pan", False), ("pn", True)])
def test_controllers_are_declared_by_the_dict_of_a_node(types: str, joint: str, is_wrong: bool, folder: Folder) -> None:
    own = f'{{"turn.type": "{FORWARD}", "joints": ["{joint}"], "interface_name": "position"}}'
    text = types.replace("JOINT", joint) if "file" in types else own
    errors = found(folder, text, file=f"turn:\n  ros__parameters: {{joints: [{joint}], interface_name: position}}\n")
    assert any(error.startswith("UC440") for error in errors) == is_wrong
    assert not any(error.startswith(("UC420", "UC601")) for error in errors)


@pytest.mark.parametrize(
    ("how", "section"),
    [
        ('ReplaceString(source_file=file, replacements={"<at>": "/left/", "<joint>": "pan"})', "<at>"),
        ('RewrittenYaml(source_file=file, root_key="left", param_rewrites={"joints": "[pan]"})', ""),
    ],
)
def test_a_rewritten_file_is_read_as_the_node_gets_it(how: str, section: str, folder: Folder) -> None:
    lines = (SECTIONS % FORWARD).replace("JOINT", "<joint>" if section else "pan").splitlines()
    file = "".join(f"{'' if line.startswith(' ') else section}{line}\n" for line in lines)
    assert found(folder, how, "left", file) == []
    wrong = how.replace('"<joint>": "pan"', '"<joint>": "pn"')
    misnamed = file.replace("[pan]", "[pn]")
    assert any(error.startswith("UC440") for error in found(folder, wrong, "left", misnamed))


def test_controllers_of_ros1_are_declared_in_the_launch_file_alone(folder: Folder) -> None:
    transmission = (
        "<transmission name='t'><type>transmission_interface/SimpleTransmission</type><joint name='pan'>"
        "<hardwareInterface>hardware_interface/PositionJointInterface</hardwareInterface></joint><actuator name='m'/>"
        "</transmission></robot>"
    )
    kind = "position_controllers/JointPositionController"
    launch = (
        "<launch><param name='robot_description' textfile='$(find p)/r.urdf'/>"
        f"<rosparam>\nturn: {{type: {kind}, joint: pn}}\n</rosparam>"
        "<node name='s' pkg='controller_manager' type='spawner' args='turn'/></launch>"
    )
    robot = ROBOT.partition("<ros2_control")[0] + transmission
    folder.write({"package.xml": MANIFEST.replace("ament_cmake", "catkin"), "r.urdf": robot, "launch/r.launch": launch})
    ran = folder.run("lint", ".", "--distro", "noetic", "--format", "json", "--exit-zero")
    errors = {(one["code"], one["file"], one["line"]) for one in json.loads(ran.stdout)["findings"]}
    assert ("UC440", "launch/r.launch", 2) in errors


RATE = 'DeclareLaunchArgument("rate", default_value="50")'


@pytest.mark.parametrize(
    ("rate", "is_wrong"),
    [
        ('LaunchConfiguration("rate")', False),
        ('[LaunchConfiguration("rate")]', False),
        ('["1", LaunchConfiguration("rate")]', False),
        ('ParameterValue(LaunchConfiguration("rate"))', False),
        ('ParameterValue(LaunchConfiguration("rate"), value_type=int)', False),
        ('TextSubstitution(text="50")', False),
        ("50", False),
        ('"50"', True),
        ('ParameterValue("50")', True),
        ('ParameterValue(LaunchConfiguration("rate"), value_type=str)', True),
        ("""TextSubstitution(text="'50'")""", True),
        ('["fast", LaunchConfiguration("rate")]', True),
    ],
)
def test_the_text_of_a_substitution_in_a_dict_is_read_as_yaml(rate: str, is_wrong: bool, folder: Folder) -> None:
    launch = LAUNCH.replace("PARAMETERS", f'{{"update_rate": {rate}}}, file').replace("NAMESPACE", "")
    launch = "from launch_ros.parameter_descriptions import ParameterValue\n" + launch
    launch = "from launch.actions import DeclareLaunchArgument\n" + launch.replace(
        "import Command\n", "import Command, LaunchConfiguration, TextSubstitution\n"
    ).replace("LaunchDescription([\n", f"LaunchDescription([\n        {RATE},\n")
    folder.write({"package.xml": MANIFEST, "r.urdf": ROBOT, "launch/r.launch.py": launch, "c.yaml": SECTIONS % FORWARD})
    ran = folder.run("lint", "launch/r.launch.py", "--distro", "jazzy", "--select", "UC432", "--exit-zero")
    assert ("UC432" in ran.stdout) == is_wrong


@pytest.mark.parametrize(
    ("given", "is_wrong"),
    [
        ('value="50"', False),
        ('value="$(var rate)"', False),
        ('value="$(var rate)" type="int"', False),
        ('value="50" type="str"', True),
        ('value="fast"', True),
    ],
)
def test_a_value_in_xml_is_read_as_yaml_unless_it_has_a_type(given: str, is_wrong: bool, folder: Folder) -> None:
    launch = (
        '<launch><arg name="rate" default="50"/><node pkg="controller_manager" exec="ros2_control_node">'
        '<param name="robot_description" value="$(command \'cat $(find-pkg-share p)/r.urdf\')"/>'
        f'<param name="update_rate" {given}/><param from="$(find-pkg-share p)/c.yaml"/></node></launch>'
    )
    folder.write({"package.xml": MANIFEST, "r.urdf": ROBOT, "r.launch.xml": launch, "c.yaml": SECTIONS % FORWARD})
    ran = folder.run("lint", "r.launch.xml", "--distro", "jazzy", "--select", "UC432", "--exit-zero")
    assert ("UC432" in ran.stdout) == is_wrong
