"""A robot of which parts are unknown names what is missing, and is tested with mock hardware if only its driver is."""

from __future__ import annotations

from pathlib import Path

import pytest
from folder import Folder
from generating import command

from urdfctl.rules.smoke.common import LIFT

CONTROL = LIFT[LIFT.index("<ros2_control") : LIFT.index("</ros2_control>") + len("</ros2_control>")]
XACRO = LIFT.replace('<robot name="lift">', '<robot name="lift" xmlns:xacro="http://www.ros.org/wiki/xacro">{}')
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    update_rate: 500
    mover: {type: joint_trajectory_controller/JointTrajectoryController}
mover:
  ros__parameters:
    joints: [%s]
    command_interfaces: [effort]
    state_interfaces: [position, velocity]
    gains: {lift: {p: 4000.0, i: 100.0, d: 400.0}}
"""
DRIVER = '<xacro:include filename="$(find lift_driver)/urdf/driver.xacro"/>'
SMOKE = "smoke robot.urdf.xacro --controllers controllers.yaml --distro jazzy --engine none".split()


def robot(folder: Folder, include: str = DRIVER, *, joint: str = "lift", without: str = CONTROL) -> None:
    folder.write(
        {"robot.urdf.xacro": XACRO.format(include).replace(without, ""), "controllers.yaml": CONTROLLERS % joint}
    )


@pytest.mark.parametrize(
    ("include", "expected"),
    [
        (DRIVER, "the robot needs package 'lift_driver', not here: clone it beside it, or --package-path FOLDER"),
        (
            '<xacro:include filename="$(arg file)"/>',
            "needs argument 'file': urdfctl smoke robot.urdf.xacro file:=VALUE",
        ),
        (
            '<xacro:include filename="$(env DRIVER)"/>',
            "needs environment variable 'DRIVER': DRIVER=VALUE urdfctl smoke robot.urdf.xacro --env DRIVER",
        ),
        (
            '<xacro:include filename="$(arg folder)/$(arg file)"/>',
            "needs arguments 'folder' and 'file': urdfctl smoke robot.urdf.xacro folder:=VALUE file:=VALUE",
        ),
    ],
)
def test_what_is_missing_is_named_with_what_adds_it(include: str, expected: str, folder: Folder) -> None:
    robot(folder, include)
    assert expected in command(*SMOKE).stdout


PARTS = LIFT.replace('<robot name="lift">', '<robot name="lift" xmlns:xacro="http://www.ros.org/wiki/xacro">{}')
ARM = """
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arm:
  ros__parameters: {joints: [shoulder], command_interfaces: [position], state_interfaces: [position]}
"""


@pytest.mark.parametrize(("include", "verdict"), [(DRIVER, "arm    skipped"), ("", "arm    failed")])
def test_what_the_hardware_of_an_absent_package_may_offer_stops_no_controller(
    include: str, verdict: str, folder: Folder
) -> None:
    declared, rest = (CONTROLLERS % "lift").split("\nmover:", 1)
    folder.write({"robot.urdf.xacro": PARTS.format(include), "controllers.yaml": f"{declared}{ARM}mover:{rest}"})
    shown = command(*SMOKE).stdout
    assert verdict in shown
    assert ("needs package 'lift_driver', not here" in shown) is bool(include)


def test_mock_hardware_takes_the_place_of_a_driver_that_is_not_in_the_files(folder: Folder) -> None:
    robot(folder)
    plain, mocked = command(*SMOKE).stdout, command(*SMOKE, "--hardware", "mock", "--format", "json").stdout
    assert "or --hardware mock, if only the driver is in there" in plain
    assert "no physics engine was used" in mocked
    assert "driver (mock hardware)" in mocked


def test_mock_hardware_takes_the_place_of_hardware_that_cannot_be_started(folder: Folder) -> None:
    broken = XACRO.format("").replace("mock_components/GenericSystem", "fake_components/GenericSystem")
    folder.write({"robot.urdf.xacro": broken, "controllers.yaml": CONTROLLERS % "lift"})
    plain, mocked = command(*SMOKE), command(*SMOKE, "--hardware", "mock")
    assert (plain.returncode, mocked.returncode) == (1, 0), mocked.stdout


def test_joints_that_are_missing_too_are_not_mocked(folder: Folder) -> None:
    robot(folder, joint="gripper")
    told = command(*SMOKE, "--hardware", "mock").stdout
    assert "needs package 'lift_driver'" in told
    assert "mock" not in told


def test_other_hardware_than_mock_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = command(*SMOKE, "--hardware", "real")
    assert (done.returncode, "unknown hardware 'real'; known is mock" in done.stderr) == (2, True)


LAUNCH = """<launch>
  <include file="$(find arm_bringup)/launch/bringup.launch"/>
  <include file="$(find {other})/launch/drive.launch"/>
  <rosparam command="load" file="$(find a)/config/planner.yaml"/>
</launch>
"""
WELDED = '<robot name="arm"><link name="base"/><link name="tip"/>{}</robot>'
FIXED = '<joint name="weld" type="fixed"><parent link="base"/><child link="tip"/></joint>'
PACKAGE = """<package format="2"><name>{}</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.c">a</maintainer><license>BSD</license><buildtool_depend>catkin</buildtool_depend></package>
"""


def test_where_nothing_has_controllers_the_packages_of_included_launch_files_are_named_once(folder: Folder) -> None:
    folder.write(
        {
            "a/package.xml": PACKAGE.format("a"),
            "a/urdf/arm.urdf": WELDED.format(FIXED),
            "a/config/planner.yaml": "rate: 10\n",
            "a/launch/one.launch": LAUNCH.format(other="arm_control"),
            "a/launch/two.launch": LAUNCH.format(other="arm_control"),
            "a/launch/three.launch": LAUNCH.format(other="a"),
        }
    )
    words = ("smoke", "a", "--engine", "none", "--distro", "noetic")
    shown = command(*words).stdout
    both = "it needs files of packages 'arm_bringup' and 'arm_control', not here: clone them beside it"
    assert shown.count(both) == 1
    assert "nothing was tested" in shown
    states = "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"
    folder.write({"a/config/arm.yaml": states})
    given = command(*words, "--controllers", "a/config/arm.yaml").stdout
    assert "it needs files of" not in given
    assert "files of package 'arm_bringup', not here: clone it beside it, or urdfctl smoke ROBOT" in given


DESCRIBED = """<launch>
  <param name="robot_description" command="$(find xacro)/xacro '$(find {})/urdf/arm.urdf'"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="mover"/>
</launch>
"""


@pytest.mark.parametrize(("package", "named"), [("arm_model", True), ("a", False)])
def test_the_package_of_a_description_that_is_not_here_is_named(package: str, named: bool, folder: Folder) -> None:
    folder.write(
        {
            "a/package.xml": PACKAGE.format("a"),
            "a/urdf/arm.urdf": WELDED.format(FIXED),
            "a/launch/one.launch": DESCRIBED.format(package),
        }
    )
    shown = command("smoke", "a/launch/one.launch", "--engine", "none", "--distro", "noetic").stdout
    assert ("it needs files of package 'arm_model', not here: clone it beside it" in shown) is named


LOADED = """<launch>
  <include file="$(find {})/launch/description.launch"/>
  <rosparam command="load" file="$(find a)/config/arm.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="states"/>
</launch>
"""


@pytest.mark.parametrize(("package", "named"), [("arm_model", True), ("a", False)])
def test_a_launch_file_without_a_robot_names_the_package_of_what_it_includes(
    package: str, named: bool, folder: Folder
) -> None:
    folder.write(
        {
            "a/package.xml": PACKAGE.format("a"),
            "a/config/arm.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
            "a/launch/description.launch": "<launch/>",
            "a/launch/one.launch": LOADED.format(package),
        }
    )
    shown = command("smoke", "a/launch/one.launch", "--engine", "none", "--distro", "noetic").stdout
    assert "the launch file starts no known robot" in shown
    assert ("files of package 'arm_model', not here: clone it beside it, or urdfctl smoke ROBOT" in shown) is named


COMPUTED = """
import os
from launch import LaunchDescription
from launch_ros.actions import Node
import xacro

HERE = os.path.dirname(__file__)
CONTROL = os.path.join(HERE, "controllers.yaml")

def generate_launch_description():
    layout = input("layout: ")
    text = xacro.process_file(os.path.join(HERE, "robot.urdf.xacro"), mappings={"layout": layout})
    description = {"robot_description": text.toxml()}
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[description]),
        Node(package="controller_manager", executable="ros2_control_node", parameters=[description, CONTROL]),
        Node(package="controller_manager", executable="spawner", arguments=["mover"]),
    ])
"""


def test_arguments_that_a_launch_file_computes_are_named_with_the_command_that_gives_them(folder: Folder) -> None:
    chosen = '<xacro:arg name="layout" default="0"/><xacro:if value="$(arg layout)"><link name="table"/></xacro:if>'
    folder.write({"robot.urdf.xacro": XACRO.format(chosen), "controllers.yaml": CONTROLLERS % "lift"})
    folder.write({"robot.launch.py": COMPUTED})
    shown = command("smoke", "robot.launch.py", "--engine", "none", "--distro", "jazzy").stdout
    assert "the launch file computes argument 'layout' of the robot: urdfctl smoke robot.urdf.xacro" in shown
    assert "layout:=VALUE" in shown


VARIANT = """<launch>
  <arg name="model" default="{}"/>
  <param name="robot_description" textfile="$(find a)/urdf/$(arg model).urdf"/>
  <rosparam command="load" file="$(find a)/config/arm.yaml"/>
  <node name="spawner" pkg="controller_manager" type="spawner" args="states"/>
</launch>
"""


@pytest.mark.parametrize("variable", ["$(env MODEL)", "$(eval env('MODEL'))"])
def test_the_variable_that_chooses_the_robot_of_a_launch_file_is_named_with_how_to_give_it(
    variable: str, folder: Folder, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder.write(
        {
            "a/package.xml": PACKAGE.format("a"),
            "a/config/arm.yaml": "states: {type: joint_state_controller/JointStateController, publish_rate: 50}\n",
            "a/urdf/arm.urdf": WELDED.format(FIXED),
            "a/launch/one.launch": VARIANT.format(variable),
        }
    )
    words = ("smoke", "a/launch/one.launch", "--engine", "none", "--distro", "noetic")
    wanted = (
        "the launch file needs environment variable 'MODEL': MODEL=VALUE urdfctl smoke a/launch/one.launch --env MODEL"
    )
    assert wanted in command(*words).stdout
    monkeypatch.setenv("MODEL", "arm")
    given = command(*words, "--env", "MODEL").stdout
    assert "needs environment variable" not in given
    assert "a/launch/one.launch: a/urdf/arm.urdf" in given


@pytest.mark.parametrize(
    ("modules", "filled", "expected"),
    [
        ("src/lift-driver", False, "git submodule update --init src/lift-driver, or --package-path FOLDER"),
        ("src/lift-driver", True, "clone it beside it, or --package-path FOLDER"),
        ("src/lift_gripper", False, "clone it beside it, or --package-path FOLDER"),
    ],
)
def test_a_package_that_is_a_submodule_is_added_by_git(
    modules: str, filled: bool, expected: str, folder: Folder
) -> None:
    robot(folder)
    folder.write({".gitmodules": f'[submodule "d"]\n\tpath = {modules}\n\turl = https://example.com/d.git\n'})
    if filled:
        folder.write({f"{modules}/README.md": "moved"})
    assert f"needs package 'lift_driver', not here: {expected}" in command(*SMOKE).stdout


@pytest.mark.parametrize(
    ("file", "expected"),
    [
        ("$(env ROBOT)", "it needs environment variable 'ROBOT': ROBOT=VALUE urdfctl smoke a/launch/one.launch"),
        ("$(anon arm).urdf", "it starts a robot whose description is known only while it runs: urdfctl smoke ROBOT"),
    ],
)
def test_a_launch_file_whose_robot_is_known_only_while_it_runs_is_named(
    file: str, expected: str, folder: Folder
) -> None:
    folder.write(
        {
            "a/package.xml": PACKAGE.format("a"),
            "a/launch/one.launch": DESCRIBED.replace("'$(find {})/urdf/arm.urdf'", file),
        }
    )
    shown = command("smoke", "a", "--engine", "none", "--distro", "noetic").stdout
    assert f"a/launch/one.launch (noetic; not simulated)\n  {expected}" in shown


@pytest.mark.parametrize(
    ("include", "more"),
    [
        (DRIVER, "; it needs files of package 'lift_driver', not here: clone it beside it, or --package-path FOLDER"),
        ("", ""),
    ],
)
def test_a_robot_without_controllers_names_the_packages_of_its_unknown_parts_once(
    include: str, more: str, folder: Folder
) -> None:
    view = """<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">
        <param name="robot_description" value="$(command 'xacro $(find-pkg-share lift)/urdf/lift.urdf.xacro')"/>
        </node></launch>"""
    folder.write(
        {
            "lift/package.xml": PACKAGE.format("lift"),
            "lift/urdf/lift.urdf.xacro": XACRO.format(include),
            "lift/launch/view.launch.xml": view,
        }
    )
    shown = command("smoke", "lift", "--distro", "jazzy", "--engine", "none").stdout
    assert shown.count(f"  no controllers are declared for this robot{more}\n") == 1
    assert "nothing was tested: no controllers found" in shown


REPOS = """repositories:
  {}:
    type: git
    url: https://example.com/{}.git
    version: main
"""
ROSINSTALL = "- git: {{local-name: {}, uri: 'https://example.com/{}.git', version: main}}\n"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"all.repos": REPOS.format("lift_driver", "lift")}, "vcs import .. < all.repos"),
        ({"all.repos": REPOS.format("drivers/lift", "lift-driver")}, "vcs import .. < all.repos"),
        ({"all.repos": REPOS.format("src/lift_driver", "lift"), "src/README": ""}, "vcs import src < all.repos"),
        ({".rosinstall": ROSINSTALL.format("lift_driver", "lift")}, "vcs import .. < .rosinstall"),
        ({"all.repos": REPOS.format("lift_gripper", "lift")}, "clone it beside it"),
        ({"sub/all.repos": REPOS.format("lift_driver", "lift")}, "clone it beside it"),
    ],
)
def test_a_package_in_a_list_of_repositories_is_imported(files: dict[str, str], expected: str, folder: Folder) -> None:
    robot(folder)
    folder.write(files)
    assert f"needs package 'lift_driver', not here: {expected}, or --package-path FOLDER" in command(*SMOKE).stdout


CHOSEN = """<robot name="test" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="scanner" params="parent"><link name="scan"/></xacro:macro>
<xacro:property name="sensor" value="$(arg sensor)"/><link name="world"/>
<xacro:{} parent="world"/>
</robot>
"""


@pytest.mark.parametrize("element", ['element xacro:name="${sensor}"', 'call macro="${sensor}"'])
def test_an_element_whose_name_is_an_argument_needs_it(element: str, folder: Folder) -> None:
    folder.write({"robot.urdf.xacro": CHOSEN.format(element)})
    shown = command("smoke", "robot.urdf.xacro", "--engine", "none", "--distro", "jazzy").stdout
    assert "; it needs argument 'sensor': urdfctl smoke robot.urdf.xacro sensor:=VALUE\n" in shown
    assert "UC901" not in shown


UR = '<xacro:include filename="$(find ur_description)/urdf/ur_macro.xacro"/>'
OF_ROS2 = "https://github.com/UniversalRobots/Universal_Robots_ROS2_Description for jazzy"


@pytest.mark.parametrize(
    ("include", "distro", "expected"),
    [
        (UR, "jazzy", f"clone {OF_ROS2} beside it"),
        (UR, "noetic", "clone https://github.com/ros-industrial/universal_robot for noetic beside it"),
        (DRIVER, "jazzy", "clone it beside it"),
        (
            f"{UR}{DRIVER}",
            "jazzy",
            f"clone {OF_ROS2} and the other beside it",
        ),
    ],
)
def test_the_repository_of_a_package_is_named_where_it_is_known(
    include: str, distro: str, expected: str, folder: Folder
) -> None:
    robot(folder, include)
    words = [distro if word == "jazzy" else word for word in SMOKE]
    assert f"not here: {expected}, or --package-path FOLDER" in command(*words).stdout
