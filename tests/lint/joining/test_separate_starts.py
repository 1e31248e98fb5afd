"""Starts that describe the robot a second time, spawn a model from a file, or take a robot from elsewhere."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = f"""<robot name="crane">
  <link name="base">{MASS}</link>
  <joint name="slew" type="revolute">
    <parent link="base"/><child link="jib"/><limit lower="-1" upper="1" effort="9" velocity="1"/>
  </joint>
  <link name="jib">{MASS}</link>
  <ros2_control name="crane" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="slew"><command_interface name="position"/><state_interface name="position"/></joint>
  </ros2_control>
</robot>"""
CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    turn: {type: forward_command_controller/ForwardCommandController}
turn:
  ros__parameters: {joints: [slew], interface_name: position}
"""
MANIFEST = "<package format='3'><name>crane</name><export><build_type>ament_cmake</build_type></export></package>"
TEXT = "$(command 'xacro $(find-pkg-share {0})/crane.urdf')"
PUBLISHER = (
    '<node pkg="robot_state_publisher" exec="robot_state_publisher">'
    f'<param name="robot_description" value="{TEXT}"/></node>'
)
MANAGER = (
    '<node pkg="controller_manager" exec="ros2_control_node">'
    '<remap from="~/robot_description" to="/robot_description"/>'
    '<param from="$(find-pkg-share crane)/controllers.yaml"/></node>'
)
PLANNER = f'<node pkg="moveit_ros_move_group" exec="move_group"><param name="robot_description" value="{TEXT}"/></node>'
SPAWNER = '<node pkg="controller_manager" exec="spawner" args="{}"/>'
DRIVER = '<node pkg="crane_driver" exec="crane_driver_node"/>'


def launch(*parts: str, package: str = "crane") -> str:
    return f"<launch>{''.join(parts)}</launch>".replace("{0}", package)


def written(folder: Folder, **launches: str) -> dict[str, Any]:
    files = {f"launch/{name}.launch.xml": text for name, text in launches.items()}
    files |= {"package.xml": MANIFEST, "crane.urdf": ROBOT, "controllers.yaml": CONTROLLERS}
    folder.write(files)
    ran = folder.run("lint", ".", "--format", "json", "--distro", "jazzy", "--exit-zero")
    assert ran.returncode == 0, ran.stderr
    given: dict[str, Any] = json.loads(ran.stdout)
    return given


def starts(given: dict[str, Any]) -> list[tuple[str, list[str], list[str]]]:
    return [(each["launch"], each["beside"], each["spawned"]) for each in given["targets"] if each["launch"]]


def errors(given: dict[str, Any]) -> list[str]:
    return [one["code"] for one in given["findings"] if one["severity"] == "error"]


@pytest.mark.parametrize(("spawned", "expected"), [("turn", []), ("trun", ["UC601"])])
def test_a_planner_with_spawners_belongs_to_the_start_of_its_robot_with_a_manager(
    folder: Folder, spawned: str, expected: list[str]
) -> None:
    given = written(folder, robot=launch(PUBLISHER, MANAGER), plan=launch(PLANNER, SPAWNER.format(spawned)))
    assert starts(given) == [("launch/robot.launch.xml", ["launch/plan.launch.xml"], [spawned])]
    assert errors(given) == expected


def test_a_planner_with_a_driver_of_its_own_is_started_beside_no_manager(folder: Folder) -> None:
    given = written(folder, robot=launch(PUBLISHER, MANAGER), plan=launch(PLANNER, DRIVER, SPAWNER.format("turn")))
    assert [beside for _, beside, _ in starts(given)] == [[], []]


def test_a_start_whose_robot_is_not_here_is_named_though_another_one_spawns_the_same(folder: Folder) -> None:
    parts = (PUBLISHER, MANAGER, SPAWNER.format("turn"))
    given = written(folder, here=launch(*parts), absent=launch(*parts, package="derrick"))
    [unjoined] = given["unjoined"]
    assert (unjoined["launch"], unjoined["lacks"]["packages"]) == ("launch/absent.launch.xml", ["derrick"])


MODEL = '<node name="m" pkg="gazebo_ros" type="spawn_model" args="-file $(find crane)/{}.urdf -urdf -model crane"/>'
WORLD = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'


@pytest.mark.parametrize(("name", "expected"), [("crane", []), ("derrick", ["UC616"])])
def test_the_file_that_roslaunch_puts_into_gazebo_is_the_robot(folder: Folder, name: str, expected: list[str]) -> None:
    robot = ROBOT.partition("<ros2_control")[0] + "</robot>"
    manifest = "<package format='2'><name>crane</name><buildtool_depend>catkin</buildtool_depend></package>"
    folder.write({"package.xml": manifest, "crane.urdf": robot, "launch/g.launch": launch(WORLD, MODEL.format(name))})
    given = json.loads(folder.run("lint", ".", "--format", "json", "--distro", "noetic", "--exit-zero").stdout)
    assert errors(given) == expected
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [each["launch"] for each in shown["targets"] if each["robot"]] == [None if expected else "launch/g.launch"]


def test_a_parameter_goes_before_the_file_that_is_put_into_gazebo(folder: Folder) -> None:
    described = '<param name="robot_description" textfile="$(find crane)/other.urdf"/>'
    robot = ROBOT.partition("<ros2_control")[0] + "</robot>"
    manifest = "<package format='2'><name>crane</name><buildtool_depend>catkin</buildtool_depend></package>"
    start = launch(WORLD, described, MODEL.format("crane"))
    folder.write({"package.xml": manifest, "crane.urdf": robot, "other.urdf": robot, "launch/g.launch": start})
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [each["robot"] for each in shown["targets"] if each["launch"]] == ["other.urdf"]


INCLUDED = '<include file="$(find-pkg-share crane)/launch/learned.launch.xml" if="$(var learned)"/>'
CHOOSING = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.conditions import LaunchConfigurationEquals
from launch.substitutions import Command, LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def manager(context):
    share = FindPackageShare("crane").perform(context)
    name = {"plain": "controllers.yaml", "policy": "learned.yaml"}[LaunchConfiguration("mode").perform(context)]
    remaps = [("~/robot_description", "/robot_description")]
    return [
        Node(
            package="controller_manager",
            executable="ros2_control_node",
            parameters=[share + "/" + name],
            remappings=remaps,
        )
    ]


def generate_launch_description():
    text = ParameterValue(Command(["xacro ", FindPackageShare("crane"), "/crane.urdf"]), value_type=str)
    learned = PathJoinSubstitution([FindPackageShare("crane"), "launch", "learned.launch.xml"])
    return LaunchDescription(
        [
            DeclareLaunchArgument("mode", default_value="plain", choices=["plain", "policy"]),
            Node(
                package="robot_state_publisher",
                executable="robot_state_publisher",
                parameters=[{"robot_description": text}],
            ),
            OpaqueFunction(function=manager),
            IncludeLaunchDescription(learned, condition=LaunchConfigurationEquals("mode", "policy")),
        ]
    )
"""


@pytest.mark.parametrize("is_declared", [True, False])
@pytest.mark.parametrize("language", ["xml", "python"])
def test_what_is_only_included_with_an_argument_is_checked_with_that_argument(
    folder: Folder, language: str, is_declared: bool
) -> None:
    learned = MANAGER.replace("controllers.yaml", "learned.yaml")
    managers = (
        MANAGER.replace("node pkg", 'node unless="$(var learned)" pkg', 1),
        learned.replace("node pkg", 'node if="$(var learned)" pkg', 1),
    )
    argument = '<arg name="learned" default="false"/>'
    name = "learned_turn" if is_declared else "other"
    folder.write({"learned.yaml": CONTROLLERS.replace("turn", name)})
    if language == "python":
        folder.write({"launch/start.launch.py": CHOOSING})
        starting = {}
    else:
        starting = {"start": launch(argument, PUBLISHER, *managers, INCLUDED)}
    given = written(folder, learned=launch(SPAWNER.format("learned_turn")), **starting)
    file = f"launch/start.launch.{'py' if language == 'python' else 'xml'}"
    found = {each["launch"]: each["spawned"] for each in given["targets"] if each["spawned"]}
    assert found == {file: ["learned_turn"]}
    assert given["unjoined"] == []
    told = [one["severity"] for one in given["findings"] if one["code"] == "UC601"]
    assert told == ([] if is_declared else ["warning"])


def test_what_only_a_file_with_a_syntax_error_includes_is_a_start(folder: Folder) -> None:
    whole = launch(PUBLISHER, MANAGER, '<include file="$(find-pkg-share crane)/launch/spawn.launch.xml"/>')
    given = written(folder, whole=whole.replace("</launch>", "</lunch>"), spawn=launch(SPAWNER.format("turn")))
    assert errors(given) == ["UC001"]
    assert "launch/spawn.launch.xml" in {each["launch"] for each in (*given["targets"], *given["unjoined"])}


def test_a_launch_file_that_only_shows_a_robot_that_is_not_here_is_named_with_its_package(folder: Folder) -> None:
    given = written(folder, here=launch(PUBLISHER, MANAGER), shown=launch(PUBLISHER, package="derrick"))
    [unjoined] = given["unjoined"]
    assert (unjoined["launch"], unjoined["lacks"]["packages"]) == ("launch/shown.launch.xml", ["derrick"])
    assert given["unused"] == []
    last = "1 launch file starts a robot of package 'derrick', not in this workspace: launch/shown.launch.xml"
    assert last in " ".join(folder.run("lint", ".", "--distro", "jazzy").stdout.split())
    text = "launch/shown.launch.xml  (starts a robot of package 'derrick', not in this workspace)"
    assert text in folder.run("show", ".").stdout


def test_show_names_what_is_not_joined_if_there_is_nothing_else(folder: Folder) -> None:
    folder.write({"package.xml": MANIFEST, "launch/absent.launch.xml": launch(PUBLISHER, package="derrick")})
    shown = folder.run("show", ".")
    assert "launch/absent.launch.xml  (starts a robot of package 'derrick'" in shown.stdout, shown.stderr


ELSEWHERE = '<include file="$(find-pkg-share {})/launch/{}.launch.py"/>'
IMPORTS = """from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource


"""


@pytest.mark.parametrize("language", ["xml", "py"])
def test_a_launch_file_that_only_starts_launch_files_that_are_not_here_is_named_with_their_packages(
    folder: Folder, language: str
) -> None:
    """Nothing is checked of what it starts. What shows a camera or a map starts no robot."""
    others = [("derrick_bringup", "start"), ("derrick_moveit_config", "demo"), ("nav2_bringup", "bringup_launch")]
    asked = "get_package_share_directory('{}') + '/launch/{}.launch.py'"
    lines = [f"IncludeLaunchDescription(PythonLaunchDescriptionSource({asked.format(*one)}))" for one in others]
    made = f"{IMPORTS}def generate_launch_description():\n    return LaunchDescription([{', '.join(lines)}])\n"
    file, text = f"launch/all.launch.{language}", launch(*(ELSEWHERE.format(*one) for one in others))
    folder.write({file: made if language == "py" else text})
    given = written(folder, here=launch(PUBLISHER, MANAGER), camera=launch(ELSEWHERE.format("zed_camera", "start")))
    packages = ["derrick_bringup", "derrick_moveit_config"]
    assert [(one["launch"], one["lacks"]["packages"]) for one in given["unjoined"]] == [(file, packages)]
    told = " ".join(folder.run("lint", file, "--distro", "jazzy").stdout.split())
    absent = "launch files of packages 'derrick_bringup' and 'derrick_moveit_config', not in this workspace"
    assert f"1 launch file starts {absent}: {file}" in told
    assert f"{file}  (starts {absent})" in folder.run("show", ".").stdout


@pytest.mark.parametrize("package", ["derrick_bringup", "derrick_launch"])
def test_what_starts_only_what_is_not_here_is_named_if_there_is_nothing_else(package: str, folder: Folder) -> None:
    folder.write({"package.xml": MANIFEST, "launch/a.launch.xml": launch(ELSEWHERE.format(package, "start"))})
    ran = folder.run("lint", ".")
    assert ran.returncode == 2, ran.stdout
    assert f"they start no robot or controllers of this workspace; not in it: '{package}'" in ran.stderr


DEMO = """
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_demo_launch


def generate_launch_description():
    config = MoveItConfigsBuilder("crane", package_name="crane").robot_description("crane.urdf").to_moveit_configs()
    demo = generate_demo_launch(config)
    demo.add_action(Node(package="controller_manager", executable="spawner", arguments=["{}"]))
    return demo
"""
STATES = "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n"


@pytest.mark.parametrize(("spawned", "expected"), [("turn", []), ("trun", ["UC601"])])
def test_what_is_added_to_the_demo_of_moveit_is_started_with_it(
    folder: Folder, spawned: str, expected: list[str]
) -> None:
    declared = CONTROLLERS.replace("    turn:", STATES.replace("states", "joint_state_broadcaster") + "    turn:")
    folder.write({"config/ros2_controllers.yaml": declared, "launch/demo.launch.py": DEMO.format(spawned)})
    folder.write({f"launch/{name}.launch.py": "" for name in ("rsp", "move_group", "spawn_controllers")})
    folder.write({"config/moveit_controllers.yaml": "moveit_simple_controller_manager: {controller_names: []}\n"})
    folder.write({"config/crane.srdf": '<robot name="crane"/>'})
    given = written(folder)
    assert starts(given) == [("launch/demo.launch.py", [], ["joint_state_broadcaster", spawned])]
    assert [code for code in errors(given) if code == "UC601"] == expected


@pytest.mark.parametrize("text", ["# see crane.launch.py of launch/", "PARTS = ['crane.launch.py']"])
def test_a_launch_file_that_another_one_only_mentions_is_a_start(folder: Folder, text: str) -> None:
    """Its name is in a comment, or in a list from which nothing is included."""
    node = "Node(package='rviz2', executable='rviz2')"
    imports = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    made = "def generate_launch_description():\n    return LaunchDescription([{}])\n"
    shown = f"{imports}# launch/crane.launch.py\nNAMES = ['/crane.launch.py']\n{text}\n{made.format(node)}"
    publisher = (
        "Node(package='robot_state_publisher', executable='robot_state_publisher', "
        "parameters=[{'robot_description': Command(['xacro ', FindPackageShare('crane'), '/crane.urdf'])}])"
    )
    more = "from launch.substitutions import Command\nfrom launch_ros.substitutions import FindPackageShare\n"
    manager = (
        "Node(package='controller_manager', executable='ros2_control_node', "
        "parameters=[[FindPackageShare('crane'), '/controllers.yaml']], "
        "remappings=[('~/robot_description', '/robot_description')])"
    )
    start = f"{imports}{more}{made.format(f'{publisher}, {manager}')}"
    folder.write({"launch/view.launch.py": shown, "launch/crane.launch.py": start})
    given = written(folder)
    assert [each["launch"] for each in given["targets"]] == ["launch/crane.launch.py"]


@pytest.mark.parametrize("command", ["textfile='$(arg model)'", "command='xacro $(arg model)'"])
def test_the_package_of_a_description_is_known_by_way_of_an_argument(folder: Folder, command: str) -> None:
    """Another robot here has the same joints."""
    manifest = "<package format='2'><name>crane</name><buildtool_depend>catkin</buildtool_depend></package>"
    robot = ROBOT.partition("<ros2_control")[0] + "</robot>"
    inner = launch('<arg name="model"/>', f'<param name="robot_description" {command}/>')
    model = '<arg name="model" value="$(find old-crane_description)/crane.urdf"/>'
    loads = '<rosparam command="load" file="$(find crane)/c.yaml"/>'
    include = f'<include file="$(find crane)/launch/model.launch.xml">{model}</include>'
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="turn"/>'
    folder.write({"package.xml": manifest, "crane.urdf": robot, "launch/model.launch.xml": inner})
    folder.write({"launch/old.launch": launch(include, loads, spawner)})
    folder.write({"c.yaml": "turn: {type: position_controllers/JointPositionController, joint: slew}\n"})
    described = '<param name="robot_description" textfile="$(find crane)/crane.urdf"/>'
    folder.write({"launch/world.launch": launch(WORLD, described)})
    given = json.loads(folder.run("lint", ".", "--format", "json", "--distro", "noetic", "--exit-zero").stdout)
    assert [each["lacks"]["packages"] for each in given["unjoined"]] == [["old-crane_description"]]
    assert starts(given) in ([], [("launch/world.launch", [], [])])


@pytest.mark.parametrize(("spawned", "expected"), [("turn", []), ("lift", ["UC601"])])
def test_a_manager_and_spawners_that_are_given_one_file_are_both_started_beside_the_robot(
    folder: Folder, spawned: str, expected: list[str]
) -> None:
    spawner = SPAWNER.format(f"{spawned} -p $(find-pkg-share crane)/controllers.yaml")
    given = written(folder, robot=launch(PUBLISHER), drive=launch(MANAGER), spawn=launch(spawner))
    [(start, beside, _)] = starts(given)
    assert {start, *beside} == {f"launch/{name}.launch.xml" for name in ("robot", "drive", "spawn")}
    assert errors(given) == expected
