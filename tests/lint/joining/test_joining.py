"""Launch files that people start beside each other: one starts a robot, another one its controllers."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

MANIFEST = '<package format="2"><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>'
JOINT = (
    '<joint name="{0}" type="revolute"><parent link="base"/><child link="{0}_link"/>'
    '<limit lower="-1" upper="1" effort="9" velocity="1"/></joint><link name="{0}_link">'
    '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
    '<transmission name="{0}_t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="{0}"><hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></joint>'
    '<actuator name="{0}_m"/></transmission>'
)
BASE = (
    '<link name="world"/><joint name="foot" type="fixed"><parent link="world"/><child link="base"/></joint>'
    '<link name="base"><inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
)
PLUGIN = '<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>'
WORLD = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'
DESCRIBED = '<param name="robot_description" textfile="$(find {})/{}"/>'
SPAWNED = '<node name="s" pkg="controller_manager" type="spawner" args="{}"/>'
LOADED = '<rosparam command="load" file="$(find {})/{}"/>'


def robot(name: str, *joints: str) -> str:
    return f'<robot name="{name}">{BASE}{"".join(map(JOINT.format, joints))}{PLUGIN}</robot>'


def controllers(**joints: str) -> str:
    kind = "effort_controllers/JointPositionController"
    lines = (f"{name}: {{type: {kind}, joint: {joints[name]}, pid: {{p: 1.0}}}}\n" for name in joints)
    return "".join(lines)


def launch(*parts: str) -> str:
    return f"<launch>{''.join(parts)}</launch>"


def package(name: str, *joints: str) -> dict[str, str]:
    """A package with a robot, and a launch file that starts it in Gazebo."""
    return {
        f"{name}/package.xml": MANIFEST.format(name),
        f"{name}/{name}.urdf": robot(name, *joints),
        f"{name}/launch/world.launch": launch(WORLD, DESCRIBED.format(name, f"{name}.urdf")),
    }


def control(package: str, **joints: str) -> dict[str, str]:
    """A launch file in a package that loads and spawns controllers, and starts no robot."""
    spawned = SPAWNED.format(" ".join(joints))
    return {
        f"{package}/c.yaml": controllers(**joints),
        f"{package}/launch/control.launch": launch(LOADED.format(package, "c.yaml"), spawned),
    }


def report(folder: Folder, *words: str) -> dict[str, Any]:
    ran = folder.run("lint", *(words or (".",)), "--format", "json", "--distro", "noetic", "--exit-zero")
    assert ran.returncode == 0, ran.stderr
    given: dict[str, Any] = json.loads(ran.stdout)
    return given


def joins(given: dict[str, Any]) -> list[tuple[str, str, list[str], list[str]]]:
    return [(each["robot"], each["launch"], each["beside"], each["spawned"]) for each in given["targets"]]


def errors(given: dict[str, Any]) -> list[tuple[str, str]]:
    return [(one["code"], one["file"]) for one in given["findings"] if one["severity"] == "error"]


WINCH = [("crane/crane.urdf", "crane/launch/world.launch", ["crane/launch/control.launch"], ["winch"])]


def test_a_robot_and_controllers_of_two_launch_files_are_checked_together(folder: Folder) -> None:
    folder.write({**package("crane", "slew", "hoist"), **control("crane", winch="hoist")})
    given = report(folder)
    assert joins(given) == WINCH
    assert given["unused"] == []
    assert errors(given) == []


@pytest.mark.parametrize("words", [[], ["crane/launch/control.launch"], ["crane/c.yaml"], ["crane/crane.urdf"]])
def test_a_joint_that_the_only_robot_lacks_is_an_error_whatever_is_named(folder: Folder, words: list[str]) -> None:
    folder.write({**package("crane", "slew", "hoist"), **control("crane", winch="hoisst")})
    given = report(folder, *words)
    assert joins(given) == WINCH
    assert ("UC440", "crane/c.yaml") in errors(given)


def test_controllers_are_joined_with_the_robot_of_another_package_that_has_their_joints(folder: Folder) -> None:
    folder.write({**package("crane", "slew", "hoist"), **package("truck", "steer"), **control("site", winch="hoist")})
    folder.write({"site/package.xml": MANIFEST.format("site")})
    given = report(folder)
    assert ("crane/crane.urdf", "crane/launch/world.launch", ["site/launch/control.launch"], ["winch"]) in joins(given)
    assert errors(given) == []


def test_controllers_of_a_robot_that_is_not_here_are_joined_with_no_other_one(folder: Folder) -> None:
    folder.write({**package("crane", "slew"), **control("site", winch="hoist")})
    folder.write({"site/package.xml": MANIFEST.format("site")})
    given = report(folder)
    assert [robot for robot, _, beside, _ in joins(given) if beside] == []
    assert errors(given) == []


@pytest.mark.parametrize(
    ("described", "beside"),
    [(['<param name="robot_description" textfile="$(env ROBOT)"/>'], []), ([], ["site/launch/control.launch"])],
)
def test_a_robot_that_is_not_known_is_not_taken_for_one_of_another_package(
    described: list[str], beside: list[str], folder: Folder
) -> None:
    folder.write({**package("crane", "slew", "hoist"), **control("site", winch="hoist")})
    loaded = launch(*described, LOADED.format("site", "c.yaml"), SPAWNED.format("winch"))
    folder.write({"site/package.xml": MANIFEST.format("site"), "site/launch/control.launch": loaded})
    assert [each[2] for each in joins(report(folder)) if each[0] == "crane/crane.urdf"] == [beside]


def test_what_only_one_of_several_starts_lacks_is_no_finding(folder: Folder) -> None:
    """Both start a robot with the joint; only one of them has a transmission for it."""
    folder.write({**package("crane", "slew", "hoist"), **control("crane", winch="hoist")})
    real = robot("crane", "slew", "hoist").replace("hoist_t", "other_t")
    folder.write({"crane/real.urdf": real, "crane/launch/real.launch": launch(DESCRIBED.format("crane", "real.urdf"))})
    assert errors(report(folder)) == []


def test_a_spawner_in_a_third_launch_file_is_joined_with_what_loads_its_controllers(folder: Folder) -> None:
    folder.write({**package("crane", "slew", "hoist"), "crane/c.yaml": controllers(winch="hoist", jib="slew")})
    folder.write({"crane/launch/load.launch": launch(LOADED.format("crane", "c.yaml"))})
    folder.write({"crane/launch/spawn.launch": launch(SPAWNED.format("winch jibb"))})
    given = report(folder)
    beside = ["crane/launch/load.launch", "crane/launch/spawn.launch"]
    assert joins(given) == [("crane/crane.urdf", "crane/launch/world.launch", beside, ["winch", "jibb"])]
    assert errors(given) == [("UC601", "crane/launch/spawn.launch")]


def test_launch_files_of_the_other_generation_are_not_joined(folder: Folder) -> None:
    mobile = '<robot name="m"><link name="base"/><link name="tip"/><joint name="hoist" type="continuous"><parent '
    mobile += 'link="base"/><child link="tip"/></joint><ros2_control name="m" type="system"><hardware><plugin>'
    mobile += 'mock_components/GenericSystem</plugin></hardware><joint name="hoist"><command_interface '
    mobile += 'name="effort"/><state_interface name="position"/></joint></ros2_control></robot>'
    folder.write({"mobile/m.urdf": mobile, "mobile/package.xml": MANIFEST.format("mobile").replace("catkin", "ament")})
    folder.write({**control("old", winch="hoist"), "old/package.xml": MANIFEST.format("old")})
    ran = folder.run("lint", ".", "--format", "json", "--exit-zero")
    assert [each["beside"] for each in json.loads(ran.stdout)["targets"]] == [[]]


def test_a_launch_file_that_fits_no_robot_is_named_last_with_the_fact_that_is_missing(folder: Folder) -> None:
    folder.write({**package("arm", "shoulder"), **control("arm", elbow="elbow_1", wrist="wrist_1")})
    ran = folder.run("lint", "arm", "--distro", "noetic")
    assert (
        "1 launch file starts controllers without a robot that fits: arm/launch/control.launch (arm/arm.urdf has no "
        "joints\n    'elbow_1' and 'wrist_1'); to check one with its robot: "
        "urdfctl lint ROBOT arm/launch/control.launch\n"
    ) in ran.stdout
    assert "not used by any robot" not in ran.stdout
    [unjoined] = json.loads(folder.run("lint", "arm", "--format", "json").stdout)["unjoined"]
    assert unjoined == {
        "launch": "arm/launch/control.launch",
        "robot": "arm/arm.urdf",
        "lacks": {"joints": ["elbow_1", "wrist_1"], "controllers": [], "packages": []},
    }
    assert "arm/launch/control.launch  (starts controllers without a robot: " in folder.run("show", "arm").stdout


def test_a_launch_file_that_is_joined_or_included_is_not_named_so(folder: Folder) -> None:
    both = launch(
        '<include file="$(find arm)/launch/control.launch"/>', '<include file="$(find arm)/launch/world.launch"/>'
    )
    folder.write({**package("arm", "shoulder"), **control("arm", turn="shoulder"), "arm/launch/all.launch": both})
    assert json.loads(folder.run("lint", "arm", "--format", "json").stdout)["unjoined"] == []


def test_the_robot_that_the_last_line_asks_for_is_checked_with_the_launch_file(folder: Folder) -> None:
    folder.write({**package("arm", "shoulder"), **control("arm", elbow="elbow_1", wrist="wrist_1")})
    ran = folder.run("lint", "arm/arm.urdf", "arm/launch/control.launch", "--distro", "noetic")
    assert "arm/c.yaml:1:66: error UC440 controller 'elbow' names joint 'elbow_1'" in ran.stdout


def test_a_launch_file_of_roslaunch_in_a_package_of_ros_2_is_joined_with_no_start_of_ros_2(folder: Folder) -> None:
    display = (
        "from launch import LaunchDescription\nfrom launch.substitutions import Command\n"
        "from launch_ros.actions import Node\nfrom ament_index_python.packages import get_package_share_directory\n\n\n"
        "def generate_launch_description():\n"
        "    text = Command(['cat ', get_package_share_directory('arm'), '/arm.urdf'])\n"
        "    return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "                                   parameters=[{'robot_description': text}])])\n"
    )
    folder.write({"arm/arm.urdf": robot("arm", "shoulder"), "arm/launch/display.launch.py": display})
    folder.write(
        {**control("arm", turn="shoulder"), "arm/package.xml": MANIFEST.format("arm").replace("catkin", "ament_cmake")}
    )
    given = json.loads(folder.run("lint", ".", "--format", "json", "--exit-zero").stdout)
    assert [each["beside"] for each in given["targets"] if each["launch"] == "arm/launch/display.launch.py"] in (
        [[]],
        [],
    )
    assert not [each for each in given["targets"] if "arm/launch/control.launch" in each["beside"]]
    assert [(one["severity"], one["file"]) for one in given["findings"] if one["code"] == "UC639"] == [
        ("warning", "arm/launch/control.launch")
    ]


def test_a_launch_file_left_over_from_ros_1_is_joined_with_nothing_of_other_packages(folder: Folder) -> None:
    folder.write({**package("crane", "slew", "hoist"), **control("site", winch="hoist")})
    folder.write({"site/package.xml": MANIFEST.format("site").replace("catkin", "ament_cmake")})
    shown = folder.run("show", ".").stdout
    absent = "it is written for ROS 1, and its package is built for ROS 2"
    assert f"site/launch/control.launch  (starts controllers without a robot: {absent})" in shown
    told = folder.run("lint", ".").stdout
    assert "site/launch/control.launch:1:62: warning UC639" in told
    assert absent not in told


@pytest.mark.parametrize(("built", "severity"), [("ament_cmake", "info"), ("catkin", "error")])
def test_what_is_found_in_a_launch_file_left_over_from_ros_1_is_only_worth_knowing(
    folder: Folder, built: str, severity: str
) -> None:
    folder.write({**package("arm", "shoulder"), **control("arm", turn="shouldr")})
    folder.write({"arm/package.xml": MANIFEST.format("arm").replace("catkin", built)})
    given = json.loads(folder.run("lint", ".", "--format", "json", "--exit-zero").stdout)
    assert {one["severity"] for one in given["findings"] if one["code"] == "UC440"} == {severity}
    assert errors(given) == ([] if severity == "info" else [("UC440", "arm/c.yaml")])


@pytest.mark.parametrize(
    "where", ["textfile='$(find crane_description)/crane.urdf'", "command='xacro $(find crane_description)/c.xacro'"]
)
def test_a_description_in_a_package_that_is_not_here_is_the_fact_that_is_missing(where: str, folder: Folder) -> None:
    text = launch(f"<param name='robot_description' {where}/>", LOADED.format("arm", "c.yaml"), SPAWNED.format("turn"))
    folder.write({**package("arm", "shoulder"), "arm/c.yaml": controllers(turn="boom"), "arm/launch/c.launch": text})
    [unjoined] = json.loads(folder.run("lint", "arm", "--format", "json").stdout)["unjoined"]
    assert unjoined["lacks"] == {"joints": [], "controllers": [], "packages": ["crane_description"]}
    said = folder.run("show", "arm").stdout
    assert "its description is in package 'crane_description', not in this workspace" in said


def test_a_part_that_a_launch_file_shows_is_not_called_unused(folder: Folder) -> None:
    shown = launch(DESCRIBED.format("arm", "table.urdf"))
    table = "<robot name='table'><link name='top'/></robot>"
    folder.write({**package("arm", "shoulder"), "arm/launch/table.launch": shown, "arm/table.urdf": table})
    assert json.loads(folder.run("show", "arm", "--format", "json").stdout)["unused"] == []
    assert "not used by any robot" not in folder.run("lint", "arm", "--distro", "noetic").stdout
    folder.write({"arm/launch/table.launch": launch()})
    assert json.loads(folder.run("show", "arm", "--format", "json").stdout)["unused"] == ["arm/table.urdf"]


DESCRIBED2 = (
    '<node pkg="robot_state_publisher" exec="robot_state_publisher">'
    '<param name="robot_description" value="$(command \'cat $(find-pkg-share crane)/crane.urdf\')" type="str"/></node>'
)
PARAMETERS = """\
controller_manager:
  ros__parameters:
    winch: {type: position_controllers/JointGroupPositionController}
winch:
  ros__parameters: {joints: [hoist]}
"""
HARDWARE = (
    '<ros2_control name="c" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>'
    '<joint name="hoist"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>'
)
MANAGED = (
    '<node pkg="controller_manager" exec="ros2_control_node"><param from="$(find-pkg-share crane)/c.yaml"/>'
    '<remap from="~/robot_description" to="/robot_description"/></node>'
)
SPAWNED2 = '<node pkg="controller_manager" exec="spawner" args="winch"/>'


def crane2(**launches: str) -> dict[str, str]:
    """A package of ROS 2, in a folder of another name, with a robot and launch files, in XML or Python."""
    manifest = '<package format="3"><name>crane</name><export><build_type>ament_cmake</build_type></export></package>'
    described = f'<robot name="crane">{BASE}{JOINT.format("hoist")}{HARDWARE}</robot>'
    files = {"package.xml": manifest, "crane.urdf": described, "c.yaml": PARAMETERS}
    files |= {f"launch/{n}.launch.{'xml' if '<launch' in text else 'py'}": text for n, text in launches.items()}
    return {f"folder/{name}": text for name, text in files.items()}


def report2(folder: Folder) -> dict[str, Any]:
    given: dict[str, Any] = json.loads(
        folder.run("lint", ".", "--format", "json", "--distro", "jazzy", "--exit-zero").stdout
    )
    return given


def started(folder: Folder) -> list[tuple[str, list[str]]]:
    return [(each["launch"], each["beside"]) for each in report2(folder)["targets"] if each["launch"]]


def test_what_is_included_is_no_start_though_the_folder_of_its_package_has_another_name(folder: Folder) -> None:
    whole = launch('<include file="$(find-pkg-share crane)/launch/model.launch.xml"/>', MANAGED, SPAWNED2)
    folder.write(crane2(model=launch(DESCRIBED2), whole=whole))
    assert started(folder) == [("folder/launch/whole.launch.xml", [])]


def test_a_launch_file_that_spawns_what_a_start_spawns_is_no_second_start(folder: Folder) -> None:
    whole = launch(DESCRIBED2, MANAGED, SPAWNED2)
    folder.write(crane2(model=launch(DESCRIBED2), whole=whole, spawn=launch(SPAWNED2)))
    assert started(folder) == [("folder/launch/model.launch.xml", []), ("folder/launch/whole.launch.xml", [])]
    assert not errors(report2(folder))


def test_a_launch_file_with_a_robot_of_a_package_that_is_not_here_is_joined_with_no_start(folder: Folder) -> None:
    absent = DESCRIBED2.replace("share crane", "share winches")
    folder.write(crane2(whole=launch(DESCRIBED2, MANAGED, SPAWNED2), other=launch(absent, MANAGED, SPAWNED2)))
    assert started(folder) == [("folder/launch/whole.launch.xml", [])]


def test_two_managers_are_never_started_beside_each_other(folder: Folder) -> None:
    """The second start takes only the description of the first, whose manager is a simulator."""
    simulated = launch(DESCRIBED2, '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>')
    folder.write(crane2(simulated=simulated, real=launch(MANAGED, SPAWNED2)))
    assert started(folder) == [("folder/launch/real.launch.xml", []), ("folder/launch/simulated.launch.xml", [])]


@pytest.mark.parametrize("kind", ["node_container", "load_composable_node"])
def test_a_robot_state_publisher_in_a_container_describes_the_robot(kind: str, folder: Folder) -> None:
    component = DESCRIBED2.replace("node", "composable_node").replace("exec=", "plugin=")
    component = component.replace('="robot_state_publisher">', '="robot_state_publisher::RobotStatePublisher">')
    folder.write(crane2(whole=launch(f'<{kind} name="c">{component}</{kind}>', MANAGED, SPAWNED2)))
    assert started(folder) == [("folder/launch/whole.launch.xml", [])]


def test_a_launch_file_that_an_argument_chooses_is_only_included(folder: Folder) -> None:
    include = '<arg name="kind" default="simple"/><include file="$(find crane)/launch/$(arg kind)_control.launch.xml"/>'
    folder.write(package("crane", "winch"))
    folder.write(control("crane", winch="winch"))
    for kind in ("simple", "other"):
        folder.write({f"crane/launch/{kind}_control.launch.xml": launch(LOADED.format("crane", "c.yaml"))})
    folder.write({"crane/launch/world.launch": launch(WORLD, DESCRIBED.format("crane", "crane.urdf"), include)})
    given = report(folder)
    assert joins(given) == WINCH
    assert given["unused"] == []
    assert given["unjoined"] == []


def test_a_launch_file_whose_description_is_missing_gets_no_other_robot(folder: Folder) -> None:
    folder.write(package("crane", "winch"))
    folder.write(control("crane", winch="winch"))
    lost = launch(DESCRIBED.format("crane", "grane.urdf"), LOADED.format("crane", "c.yaml"), SPAWNED.format("winch"))
    folder.write({"crane/launch/control.launch": lost})
    given = report(folder)
    assert errors(given) == [("UC616", "crane/launch/control.launch")]
    assert [each["launch"] for each in given["targets"]] == ["crane/launch/world.launch"]
    assert [(each["launch"], each["lacks"]["description"]) for each in given["unjoined"]] == [
        ("crane/launch/control.launch", "crane/grane.urdf")
    ]


def test_a_launch_file_that_spawns_what_a_start_spawns_itself_is_not_started_beside_it(folder: Folder) -> None:
    folder.write(package("crane", "winch"))
    folder.write(control("crane", winch="winch"))
    whole = launch(
        WORLD, DESCRIBED.format("crane", "crane.urdf"), LOADED.format("crane", "c.yaml"), SPAWNED.format("winch")
    )
    folder.write({"crane/launch/world.launch": whole})
    given = report(folder)
    assert joins(given) == [("crane/crane.urdf", "crane/launch/world.launch", [], ["winch"])]
    assert errors(given) == []
    assert given["unjoined"] == []


def test_nodes_of_two_launch_files_that_are_started_beside_each_other_may_have_one_name(folder: Folder) -> None:
    folder.write(package("crane", "winch"))
    folder.write(control("crane", winch="winch"))
    node = '<node name="s" pkg="rviz" type="rviz"/>'
    world = launch(WORLD, DESCRIBED.format("crane", "crane.urdf"), node)
    folder.write({"crane/launch/world.launch": world})
    assert (joins(report(folder)), errors(report(folder))) == (WINCH, [])
    folder.write({"crane/launch/world.launch": world.replace(node, node * 2)})
    assert errors(report(folder)) == [("UC633", "crane/launch/world.launch")]


def test_analyzers_of_the_diagnostics_are_no_controllers(folder: Folder) -> None:
    folder.write(package("crane", "winch"))
    analyzers = "analyzers: {motors: {type: diagnostic_aggregator/AnalyzerGroup, path: Motors}}\n"
    loaded = LOADED.format("crane", "a.yaml")
    node = f'<node name="a" pkg="diagnostic_aggregator" type="aggregator_node">{loaded}</node>'
    folder.write({"crane/a.yaml": analyzers, "crane/launch/dashboard.launch": launch(node)})
    given = report(folder)
    assert [(each["launch"], each["controllers"]) for each in given["targets"]] == [("crane/launch/world.launch", [])]
    assert given["unjoined"] == []


def test_a_launch_file_that_plans_for_a_robot_without_controllers_is_shown(folder: Folder) -> None:
    folder.write(package("crane", "winch"))
    node = '<node name="move_group" pkg="moveit_ros_move_group" type="move_group"/>'
    folder.write({"crane/launch/plan.launch": launch(DESCRIBED.format("crane", "crane.urdf"), node)})
    launches = {each["launch"] for each in report(folder)["targets"]}
    assert launches == {"crane/launch/world.launch", "crane/launch/plan.launch"}


def test_a_program_with_a_manager_in_it_loads_what_has_a_section_for_the_manager(folder: Folder) -> None:
    program = MANAGED.replace('pkg="controller_manager" exec="ros2_control_node"', 'pkg="drivers" exec="{}"')
    described = DESCRIBED2.replace(
        'pkg="robot_state_publisher" exec="robot_state_publisher"', 'pkg="drivers" exec="{}"'
    )
    other = described.replace("</node>", '<param from="$(find-pkg-share crane)/c.yaml"/></node>')
    for text in (program.format("control_node"), other.format("crane_main")):
        folder.write(crane2(whole=launch(DESCRIBED2, text, SPAWNED2)))
        (target,) = report2(folder)["targets"]
        assert (target["controllers"], target["spawned"]) == (["folder/c.yaml"], ["winch"])


IN_PYTHON = """\
import os, re, xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from pathlib import Path
from launch_ros.actions import Node


def generate_launch_description():
    path = os.path.join(get_package_share_directory('crane'), 'crane.urdf')
    text = xacro.process_file(path).toxml()
    {}
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', {}),
        Node(package='controller_manager', executable='spawner', arguments=['winch']),
    ])
"""
AS_FILE = "arguments=['/tmp/crane.urdf']"
AS_TEXT = "parameters=[{'robot_description': text}]"


@pytest.mark.parametrize(
    ("made", "given"),
    [
        ("with open('/tmp/crane.urdf', 'w') as file: file.write(text)", AS_FILE),
        ("file = open('/tmp/crane.urdf', mode='w'); file.write(text.replace('package://', 'file://'))", AS_FILE),
        ("Path('/tmp/crane.urdf').write_text(text)", AS_FILE),
        ("for block in re.findall('<a.*?</a>', other()): text = text.replace('</robot>', block + '</robot>')", AS_TEXT),
    ],
)
def test_a_description_that_the_launch_file_changes_or_writes_is_that_of_its_file(
    made: str, given: str, folder: Folder
) -> None:
    folder.write(crane2(whole=IN_PYTHON.format(made, given)))
    (target,) = report2(folder)["targets"]
    assert (target["robot"], target["launch"]) == ("folder/crane.urdf", "folder/launch/whole.launch.py")


@pytest.mark.parametrize("joint", ["hoist", "hoisst"])
def test_controllers_in_the_launch_file_itself_are_not_replaced_by_a_file_that_nothing_uses(
    folder: Folder, joint: str
) -> None:
    inline = f"<rosparam>\n{controllers(winch=joint)}</rosparam>"
    start = launch(WORLD, DESCRIBED.format("crane", "crane.urdf"), inline, SPAWNED.format("winch"))
    folder.write({**package("crane", "slew", "hoist"), "crane/launch/world.launch": start})
    folder.write({"crane/old/c.yaml": controllers(winch="lift")})
    assert errors(report(folder)) == ([] if joint == "hoist" else [("UC440", "crane/launch/world.launch")])


@pytest.mark.parametrize("space", ["blue", "second"])
def test_a_file_for_the_namespace_of_no_robot_belongs_to_the_robot_that_lacks_one(folder: Folder, space: str) -> None:
    names = ("red", "blue")
    described = [f'<param name="{name}/robot_description" textfile="$(find crane)/{name}.urdf"/>' for name in names]
    loaded = [LOADED.format("crane", f"{name}.yaml") for name in names]
    spawned = [SPAWNED.format(f"winch --namespace /{name}").replace('"s"', f'"{name}"') for name in names]
    folder.write({f"crane/{name}.urdf": robot(name, f"{name}_hoist") for name in names})
    for name, key in (("red", "red"), ("blue", space)):
        inside = controllers(winch=f"{name}_hoist").replace("winch:", "  winch:")
        folder.write({f"crane/{name}.yaml": f"{key}:\n{inside}"})
    folder.write({"crane/package.xml": MANIFEST.format("crane")})
    folder.write({"crane/launch/start.launch": launch(WORLD, *described, *loaded, *spawned)})
    given = report(folder)
    assert {each["namespace"]: each["controllers"] for each in given["targets"] if each["launch"]} == {
        "/red": ["crane/red.yaml"],
        "/blue": ["crane/blue.yaml"],
    }
    assert errors(given) == ([] if space == "blue" else [("UC601", "crane/launch/start.launch")])


@pytest.mark.parametrize("argument", ["", '<arg name="rate" default="10"/>'])
@pytest.mark.parametrize("spawned", ["winch", "wench"])
def test_a_launch_file_with_a_robot_that_is_included_only_with_an_argument_is_a_start_too(
    folder: Folder, spawned: str, argument: str
) -> None:
    """If it may get arguments that are not its defaults, what is found in it is a warning at most."""
    include = '<include file="$(find crane)/launch/{0}.launch" {1}="$(arg tall)"/>'
    start = launch('<arg name="tall" default="false"/>', include.format("tall", "if"), include.format("low", "unless"))
    parts = (WORLD, DESCRIBED.format("crane", "crane.urdf"), LOADED.format("crane", "c.yaml"))
    tall, low = launch(argument, *parts, SPAWNED.format(spawned)), launch(*parts, SPAWNED.format("winch"))
    folder.write({**package("crane", "slew", "hoist"), "crane/c.yaml": controllers(winch="hoist")})
    named = {"world": start, "tall": tall, "low": low}
    folder.write({f"crane/launch/{name}.launch": text for name, text in named.items()})
    given = report(folder)
    assert {launched: names for _, launched, _, names in joins(given)} == {
        "crane/launch/world.launch": ["winch"],
        "crane/launch/tall.launch": [spawned],
    }
    severity = "warning" if argument else "error"
    assert [one["severity"] for one in given["findings"] if one["code"] == "UC601"] == [severity] * (spawned != "winch")
