"""Which controller files and launch files belong to a robot, and what is known of them then."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

from urdfctl.config.settings import Settings
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.load.target import Target
from urdfctl.model.controllers import Controllers
from urdfctl.model.project import Project

ROBOT = """\
<robot name="r">
  <link name="base"/>
  <link name="tip"/>
  <joint name="j" type="revolute">
    <parent link="base"/><child link="tip"/><limit effort="1" velocity="1" lower="0" upper="1"/>
  </joint>
  {}
</robot>
"""
PLUGIN = '<gazebo><plugin filename="libgz_ros2_control-system.so" name="p">{}</plugin></gazebo>'
ROS2 = (
    "controller_manager:\n  ros__parameters:\n    arm: {type: a_controller/A}\narm:\n  ros__parameters: {joints: [j]}\n"
)
ROS1 = "arm: {type: position_controllers/JointPositionController, joint: j}\n"


def project(target: Target, settings: Settings) -> Project:
    """The project that a target becomes."""
    return lint_target(Loader(settings), target, Selection()).project


def controllers(project: Project) -> Controllers:
    assert project.controllers is not None
    return project.controllers


def targets(folder: Folder, *words: str) -> list[dict[str, Any]]:
    """The targets of a run's JSON report."""
    ran = folder.run("lint", *words, "--format", "json", "--exit-zero")
    assert ran.returncode == 0, ran.stderr
    found: list[dict[str, Any]] = json.loads(ran.stdout)["targets"]
    return found


def codes(folder: Folder, *words: str) -> list[tuple[str, str, int]]:
    ran = folder.run("lint", *words, "--format", "json", "--exit-zero", "--select", "UC0")
    return [(f["code"], f["file"], f["line"]) for f in json.loads(ran.stdout)["findings"]]


# -- the command line and the plugin ---------------------------------------------------------------------------------


def test_files_named_beside_one_robot_belong_to_it(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "c.yaml": ROS2, "d.yaml": "arm: {ros__parameters: {x: 1}}"})
    (target,) = targets(folder, "r.urdf", "c.yaml", "d.yaml")
    assert (target["robot"], target["controllers"], target["ros"]) == ("r.urdf", ["c.yaml", "d.yaml"], 2)


def test_files_named_beside_several_robots_stand_alone(folder: Folder) -> None:
    folder.write({"a.urdf": ROBOT.format(""), "b.urdf": ROBOT.format(""), "c.yaml": ROS2})
    found = targets(folder, "a.urdf", "b.urdf", "c.yaml")
    assert [(t["robot"], t["controllers"]) for t in found] == [("a.urdf", []), ("b.urdf", []), (None, ["c.yaml"])]


def test_a_plugin_of_another_name_names_a_file_too_if_it_has_controllers(folder: Folder) -> None:
    own = PLUGIN.replace("libgz_ros2_control-system.so", "our_hardware-system")
    for text, expected in ((ROS2, ["c.yaml"]), ("topics: [a, b]\n", [])):
        named = f"<parameters>{folder.path}/c.yaml</parameters>"
        folder.write({"r.urdf": ROBOT.format(own.format(named)), "c.yaml": text})
        (target,) = targets(folder, "r.urdf")
        assert target["controllers"] == expected


@pytest.mark.parametrize("simulated", [True, False])
def test_without_a_simulator_the_plugin_loads_no_file(folder: Folder, simulated: bool) -> None:
    named = f"<parameters>{folder.path}/plugin.yaml</parameters>"
    manager = '<node pkg="controller_manager" exec="ros2_control_node"><param from="$(dirname)/c.yaml"/></node>'
    publisher = (
        '<node pkg="robot_state_publisher" exec="robot_state_publisher">'
        '<param name="robot_description" value="$(command \'cat $(dirname)/r.urdf\')"/></node>'
    )
    world = '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>' if simulated else ""
    other = ROS2.replace("arm", "other")
    folder.write({"r.urdf": ROBOT.format(PLUGIN.format(named)), "c.yaml": ROS2, "plugin.yaml": other})
    folder.write({"r.launch.xml": f"<launch>{world}{publisher}{manager}</launch>"})
    (target,) = targets(folder, "r.launch.xml")
    assert target["controllers"] == (["plugin.yaml", "c.yaml"] if simulated else ["c.yaml"])


def test_a_controllers_file_alone_is_a_target(folder: Folder) -> None:
    folder.write({"c.yaml": ROS2})
    (target,) = targets(folder, "c.yaml")
    assert (target["robot"], target["controllers"], target["ros"]) == (None, ["c.yaml"], 2)
    assert folder.run("lint", "c.yaml").stdout.endswith(" in c.yaml (ROS 2, from ros__parameters)\n")


def test_a_plugin_names_its_files_and_what_is_missing_is_a_fact(folder: Folder) -> None:
    here = str(folder.path)
    inside = f"<parameters> {here}/c.yaml </parameters><parameters>{here}/no.yaml</parameters>"
    inside += "<parameters>$(find p)/c.yaml</parameters>"
    folder.write({"r.urdf": ROBOT.format(PLUGIN.format(inside)), "c.yaml": ROS2})
    made = project(Target("r.urdf"), Settings())
    found = controllers(made)
    assert [file.path for file in found.files] == [f"{here}/c.yaml"]
    assert [(r.path, r.exists, r.at.span.text) for r in found.references] == [
        (f"{here}/c.yaml", True, f"{here}/c.yaml"),
        (f"{here}/no.yaml", False, f"{here}/no.yaml"),
        (None, None, "$(find p)/c.yaml"),
    ]
    assert not found.complete
    assert made.problems == ()


def test_xacro_resolves_the_package_of_a_plugins_file(folder: Folder) -> None:
    text = ROBOT.format(PLUGIN.format("<parameters>$(find p)/config/c.yaml</parameters>"))
    text = text.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" ')
    folder.write({"p/package.xml": "<package><name>p</name></package>", "p/r.xacro": text, "p/config/c.yaml": ROS2})
    found = controllers(project(Target("p/r.xacro"), Settings()))
    assert [c.name for c in found.controllers] == ["arm"]
    assert found.complete


def test_a_file_outside_the_workspace_is_not_read(folder: Folder) -> None:
    folder.write({"w/r.urdf": ROBOT.format(PLUGIN.format(f"<parameters>{folder.path}/c.yaml</parameters>"))})
    folder.write({"c.yaml": ROS2})
    made = project(Target("w/r.urdf"), Settings(workspace="w"))
    (reference,) = controllers(made).references
    assert (reference.exists, controllers(made).files) == (None, ())


def test_a_file_that_the_user_names_has_to_be_there(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format("")})
    made = project(Target("r.urdf", controllers=("no.yaml",)), Settings())
    assert [problem.kind.name for problem in made.problems] == ["FILE_NOT_FOUND"]


def test_faults_of_yaml_are_told_where_they_stand_and_can_be_ignored(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "c.yaml": "a: 1\na: 2\n# urdfctl: ignore[UC025] on purpose\na: 3\n"})
    assert codes(folder, "r.urdf", "c.yaml") == [("UC025", "c.yaml", 2)]
    folder.write({"c.yaml": "a: 1 # urdfctl: ignore[UC025] no reason\n"})
    assert codes(folder, "c.yaml") == [("UC099", "c.yaml", 1)]


def test_rosparam_takes_no_tab_behind_a_colon_and_rcl_does(folder: Folder) -> None:
    folder.write({"1.yaml": ROS1.replace(": j", ":\tj"), "2.yaml": ROS2.replace(": [j", ":\t[j")})
    assert codes(folder, "1.yaml") == [("UC026", "1.yaml", 1)]
    assert codes(folder, "2.yaml") == []


def test_all_that_the_files_declare_may_be_started(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "c.yaml": ROS1 + "hand: {type: acme/Hand}\n"})
    target = Target("r.urdf", controllers=("c.yaml",))
    for started, told in ((("all",), False), (("hand", "arm"), True)):
        found = project(target, Settings(workspace=str(folder.path), started=started))
        assert (found.started, found.in_order) == (("/arm", "/hand") if started == ("all",) else started, told)


def test_what_is_started_is_what_the_user_says(folder: Folder) -> None:
    folder.write({"r.urdf": ROBOT.format(""), "c.yaml": ROS2})
    made = project(Target("r.urdf", controllers=("c.yaml",)), Settings(started=("arm", "x")))
    assert made.started == ("arm", "x")
    assert [c.name for c in controllers(made).controllers] == ["arm", "x"]
    every = project(Target("r.urdf", controllers=("c.yaml",)), Settings(started=("all",)))
    assert every.started == ("/arm",)


# -- launch files ----------------------------------------------------------------------------------------------------

LAUNCH = """\
<launch>
  <arg name="ns" default="robot"/>
  <param name="robot_description" command="$(find xacro)/xacro '$(find p)/r.urdf'"/>
  <group ns="$(arg ns)">
    <rosparam file="$(find p)/c.yaml"/>
    <node name="s" pkg="controller_manager" type="spawner" args="arm"/>
  </group>
</launch>
"""
PACKAGE = {
    "p/package.xml": "<package><name>p</name></package>",
    "p/r.urdf": ROBOT.format(""),
    "p/c.yaml": ROS1,
    "p/launch/l.launch": LAUNCH,
}


@pytest.mark.parametrize("words", [["p"], ["p/launch/l.launch"], ["p/r.urdf", "p/launch/l.launch"]])
def test_a_launch_file_pairs_a_robot_with_its_controllers(folder: Folder, words: list[str]) -> None:
    folder.write(PACKAGE)
    found = targets(folder, *words)
    assert found[-1]["robot"] == "p/r.urdf"
    assert found[-1]["controllers"] == ["p/c.yaml"]
    assert found[-1]["launch"] == "p/launch/l.launch"
    assert found[-1]["ros"] == 1
    assert {target["robot"] for target in found} == {"p/r.urdf"}


def test_a_launch_file_tells_namespace_and_what_is_started(folder: Folder) -> None:
    folder.write(PACKAGE)
    made = project(Target("p/launch/l.launch"), Settings())
    assert made.robot is not None
    assert made.started == ("/robot/arm",)
    assert [(c.full_name, c.type is not None) for c in controllers(made).controllers] == [("/robot/arm", True)]
    other = project(Target("p/launch/l.launch", (("ns", "x"),)), Settings(started=("arm",)))
    assert other.started == ("arm",)
    assert [c.full_name for c in controllers(other).controllers] == ["/x/arm"]


def test_a_name_that_is_started_elsewhere_has_no_type(folder: Folder) -> None:
    folder.write({**PACKAGE, "p/launch/l.launch": LAUNCH.replace('type="spawner"', 'type="spawner" ns="/other"')})
    found = controllers(project(Target("p/launch/l.launch"), Settings()))
    assert [(c.full_name, c.type is None) for c in found.controllers] == [("/robot/arm", False), ("/other/arm", True)]


def test_a_launch_file_without_a_robot_is_a_target_too(folder: Folder) -> None:
    text = "\n".join(line for line in LAUNCH.splitlines() if "robot_description" not in line)
    folder.write({**PACKAGE, "p/launch/l.launch": text})
    folder.write({"p/r.urdf": "<robot name='r'><link name='base'/></robot>"})
    (target,) = targets(folder, "p/launch/l.launch")
    assert (target["robot"], target["controllers"], target["launch"]) == (None, ["p/c.yaml"], "p/launch/l.launch")


def test_what_a_condition_leaves_open_is_paired_but_nothing_is_missing(folder: Folder) -> None:
    text = LAUNCH.replace("<rosparam ", '<rosparam if="$(env SIMULATED)" ')
    folder.write({**PACKAGE, "p/launch/l.launch": text})
    found = controllers(project(Target("p/launch/l.launch"), Settings()))
    assert ([file.path[-8:] for file in found.files], found.complete) == (["p/c.yaml"], False)


def test_a_file_that_a_launch_file_fills_in_is_read_as_it_is_then(folder: Folder) -> None:
    text = LAUNCH.replace("<rosparam ", '<arg name="prefix" default="left_"/><rosparam subst_value="true" ')
    folder.write({**PACKAGE, "p/launch/l.launch": text, "p/c.yaml": ROS1.replace("arm:", "$(arg prefix)arm:")})
    found = controllers(project(Target("p/launch/l.launch"), Settings()))
    assert "left_arm" in {controller.name for controller in found.controllers}


def test_a_file_for_moveit_configures_no_controllers(folder: Folder) -> None:
    node = '<node name="move_group" pkg="moveit_ros_move_group" type="move_group"/>'
    load = '<rosparam file="$(find p)/m.yaml" ns="move_group"/>'
    text = LAUNCH.replace("</launch>", f"{node}{load}</launch>")
    folder.write({**PACKAGE, "p/launch/l.launch": text, "p/m.yaml": ROS1.replace("arm", "other")})
    (target,) = targets(folder, "p/launch/l.launch")
    assert target["controllers"] == ["p/c.yaml"]


def test_sections_of_combined_hardware_are_no_controllers(folder: Folder) -> None:
    hardware = "robot_hardware: [left]\nleft: {type: some_hw/LeftHW}\n"
    folder.write({**PACKAGE, "p/launch/l.launch": LAUNCH, "p/c.yaml": ROS1 + hardware})
    found = controllers(project(Target("p/launch/l.launch"), Settings()))
    assert "left" not in {controller.name for controller in found.controllers}


def test_a_launch_file_that_is_no_xml_is_told_of_where_it_is_named(folder: Folder) -> None:
    folder.write({"l.launch": "<launch><node></launch>"})
    assert codes(folder, "l.launch") == [("UC001", "l.launch", 1)]


XML2 = """\
<launch>
  <arg name="ns" default="robot"/>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share p)/r.urdf')"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node" namespace="$(var ns)">
    <param from="$(find-pkg-share p)/c.yaml"/>
  </node>
  <node pkg="controller_manager" exec="spawner" namespace="$(var ns)" args="arm --controller-manager-timeout 60"/>
</launch>
"""
YAML2 = """\
launch:
- arg: {name: ns, default: robot}
- node:
    pkg: robot_state_publisher
    exec: robot_state_publisher
    param: [{name: robot_description, value: "$(command 'xacro $(find-pkg-share p)/r.urdf')"}]
- group:
  - push_ros_namespace: {namespace: $(var ns)}
  - node:
      pkg: controller_manager
      exec: ros2_control_node
      param:
      - from: $(find-pkg-share p)/c.yaml
  - node: {pkg: controller_manager, exec: spawner, args: arm}
"""
PYTHON2 = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare("p")
    description = {"robot_description": Command(["xacro ", PathJoinSubstitution([share, "r.urdf"])])}
    ns = LaunchConfiguration("ns")
    return LaunchDescription([
        DeclareLaunchArgument("ns", default_value="robot"),
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[description]),
        Node(package="controller_manager", executable="ros2_control_node", namespace=ns,
             parameters=[PathJoinSubstitution([share, "c.yaml"])]),
        Node(package="controller_manager", executable="spawner", namespace=ns, arguments=["arm"]),
    ])
"""


@pytest.mark.parametrize(("name", "text"), [("l.launch.xml", XML2), ("l.launch.yaml", YAML2), ("l.launch.py", PYTHON2)])
def test_launch_files_of_ros_2_pair_a_robot_with_its_controllers(folder: Folder, name: str, text: str) -> None:
    launch = f"p/launch/{name}"
    folder.write({**PACKAGE, "p/c.yaml": ROS2, launch: text})
    (folder.path / "p/launch/l.launch").unlink()
    for word in (launch, "p"):
        found = targets(folder, word)[-1]
        assert (found["robot"], found["controllers"], found["launch"]) == ("p/r.urdf", ["p/c.yaml"], launch)
    made = project(Target(launch), Settings())
    assert made.started == ("/robot/arm",)
    assert [(c.full_name, c.type is None) for c in controllers(made).controllers] == [
        ("/arm", False),
        ("/robot/arm", True),
    ]
    folder.write({"p/c.yaml": ROS2.replace("controller_manager:", "/**/controller_manager:")})
    found = controllers(project(Target(launch), Settings()))
    assert [(c.full_name, c.type is None) for c in found.controllers] == [("/robot/arm", False)]


def test_launch_files_that_describe_nothing_are_no_robots(folder: Folder) -> None:
    folder.write({"l.launch.xml": '<launch><node pkg="p" exec="e"/></launch>', "m.launch.py": "import os"})
    found = targets(folder, "l.launch.xml", "m.launch.py")
    assert [(target["robot"], target["controllers"]) for target in found] == [(None, []), (None, [])]


# -- folders ---------------------------------------------------------------------------------------------------------


def test_in_folders_only_what_configures_controllers_is_linted_alone(folder: Folder) -> None:
    files = {
        "manager.yaml": ROS2,
        "ros1.yaml": ROS1,
        "flow.yaml": "ns: {arm: {type: effort_controllers/JointPositionController}}",
        "nav.yaml": "amcl: {ros__parameters: {x: 1}}",
        "moveit.yaml": "controller_list:\n- {name: arm, type: FollowJointTrajectory}",
        "template.yaml": ROS1 + "x: {{ y }}",
        "other.yaml": "a: 1",
    }
    folder.write({name: f"{text}\n{name[0]}: 1\n{name[0]}: 2\n" for name, text in files.items()})
    assert {file for _, file, _ in codes(folder, ".")} == {"manager.yaml", "ros1.yaml", "flow.yaml"}
    assert targets(folder, ".") == []
    assert "3 files not used by any robot: flow.yaml, manager.yaml, ros1.yaml" in folder.run("lint", ".").stdout


def test_in_folders_a_file_that_a_robot_uses_is_not_linted_again(folder: Folder) -> None:
    folder.write(PACKAGE)
    ran = folder.run("lint", "p", "--select", "UC0")
    assert ran.stdout.endswith("no findings in p/r.urdf (ROS 1, from its controllers' types)\n")


def test_a_launch_file_that_another_includes_is_not_linted_by_itself(folder: Folder) -> None:
    outer = '<launch><include file="$(find p)/launch/l.launch"><arg name="ns" value="x"/></include></launch>'
    folder.write({**PACKAGE, "p/launch/outer.launch": outer})
    found = targets(folder, "p")
    assert [target["launch"] for target in found] == ["p/launch/outer.launch"]


def test_a_robot_that_a_launch_file_brings_is_not_linted_again_by_itself(folder: Folder) -> None:
    folder.write(PACKAGE)
    assert [target["launch"] for target in targets(folder, "p")] == ["p/launch/l.launch"]
    assert [target["launch"] for target in targets(folder, "p", "p/r.urdf")] == [None, "p/launch/l.launch"]
    assert [target["launch"] for target in targets(folder, "p", "side:=left")] == [None, "p/launch/l.launch"]


def test_a_launch_file_that_is_at_fault_is_told_of_though_it_starts_no_controllers(folder: Folder) -> None:
    launch = (
        '<launch><include file="$(find p)/launch/nowhere.launch"/><rosparam command="load" file="a.yaml"/></launch>'
    )
    folder.write({**PACKAGE, "p/launch/l.launch": launch})
    assert (
        "p/launch/l.launch:1:24: error UC616 included launch file does not exist: 'p/launch/nowhere.launch'"
        in folder.run("lint", "p").stdout
    )


def test_a_file_in_a_folder_without_manifest_is_for_ros_2_where_all_packages_beside_are(folder: Folder) -> None:
    ament = "<package><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
    folder.write({"s/a/package.xml": ament.format("a"), "s/b/package.xml": ament.format("b")})
    folder.write({"s/c/config/c.yaml": ROS1, "s/c/c.yaml": ROS1, "config/c.yaml": ROS1})
    assert project(Target("s/c/config/c.yaml"), Settings()).ros == 2
    assert project(Target("s/c/c.yaml"), Settings()).ros == 1
    assert project(Target("config/c.yaml"), Settings()).ros == 1
    assert codes(folder, "s/c/config/c.yaml") == []
    assert project(Target("no/such/folder/config/c.yaml"), Settings()).problems
    folder.write({"s/b/package.xml": "<package><name>b</name><buildtool_depend>catkin</buildtool_depend></package>"})
    assert project(Target("s/c/config/c.yaml"), Settings()).distro_from == "its controllers' types"


@pytest.mark.parametrize(("of_moveit", "is_wrong"), [("r.urdf", True), ("welder.urdf", False)])
def test_an_srdf_is_for_the_description_that_move_group_gets(of_moveit: str, is_wrong: bool, folder: Folder) -> None:
    launch = XML_MOVEIT.replace("OF_MOVEIT", of_moveit)
    robot = "<robot name='r'><link name='base'/></robot>"
    welder = "<robot name='r'><link name='base'/><link name='torch'/><joint name='j' type='fixed'>"
    welder += "<parent link='base'/><child link='torch'/></joint></robot>"
    semantic = "<robot name='r'><group name='all'><link name='torch'/></group></robot>"
    folder.write({"p/package.xml": MANIFEST2, "p/r.urdf": robot, "p/welder.urdf": welder, "p/r.srdf": semantic})
    folder.write({"p/launch/l.launch.xml": launch})
    ran = folder.run("lint", "p/launch/l.launch.xml", "--distro", "jazzy", "--format", "concise")
    assert ("UC657" in ran.stdout) == is_wrong


@pytest.mark.parametrize(
    ("of_publisher", "package", "shown"),
    [
        ("r.urdf", "moveit_ros_move_group", "description p/r.urdf"),
        ("gone.urdf", "moveit_ros_move_group", "(starts a robot whose description 'p/gone.urdf' does not exist)"),
        ("made/$(var x).urdf", "moveit_ros_move_group", "description p/welder.urdf"),
        ("r.urdf", "client", "description p/r.urdf"),
    ],
)
def test_the_description_of_move_group_replaces_no_lost_one(
    of_publisher: str, package: str, shown: str, folder: Folder
) -> None:
    launch = XML_MOVEIT.replace("OF_MOVEIT", "welder.urdf").replace("r.urdf')", f"{of_publisher}')", 1)
    launch = launch.replace("moveit_ros_move_group", package).replace("<launch>", '<launch><arg name="x"/>')
    robot = "<robot name='r'><link name='base'/></robot>"
    folder.write({"p/package.xml": MANIFEST2, "p/r.urdf": robot, "p/welder.urdf": robot})
    folder.write({"p/launch/l.launch.xml": launch})
    told = folder.run("show", "p").stdout
    assert shown in told
    assert ("move_group" in told) == (package != "client" and "gone" not in of_publisher)


@pytest.mark.parametrize(("package", "started"), [("moveit_ros_move_group", True), ("client", False)])
def test_a_program_of_another_package_with_the_name_of_move_group_starts_no_robot(
    package: str, started: bool, folder: Folder
) -> None:
    launch = CLIENT.replace("PACKAGE", package)
    folder.write({"p/package.xml": MANIFEST2, "p/r.urdf": "<robot name='r'><link name='base'/></robot>"})
    folder.write({"p/launch/l.launch.xml": launch})
    assert ("p/launch/l.launch.xml" in folder.run("show", "p").stdout) == started


CLIENT = """\
<launch>
  <node pkg="PACKAGE" exec="move_group">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share p)/r.urdf')"/>
  </node>
</launch>
"""
XML_MOVEIT = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share p)/r.urdf')"/>
  </node>
  <node pkg="moveit_ros_move_group" exec="move_group">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share p)/OF_MOVEIT')"/>
    <param name="robot_description_semantic" value="$(command 'cat $(find-pkg-share p)/r.srdf')"/>
  </node>
</launch>
"""
MANIFEST2 = "<package format='3'><name>p</name><export><build_type>ament_cmake</build_type></export></package>"
