"""What a migration from Gazebo Classic to gz makes of launch files in Python, XML and YAML."""

from __future__ import annotations

import pytest
from classic_packages import CONTROL, CONTROLLERS, DRIVE, base, migrated
from folder import Folder

BRIDGE = '<param name="config_file" value="$(find-pkg-share base)/config/bridge.yaml"/>'


def after(folder: Folder, name: str, text: str, gazebo: str = CONTROL) -> str:
    """A launch file after its migration."""
    files = {"urdf/base.xacro": base(gazebo), "config/controllers.yaml": CONTROLLERS, f"launch/{name}": text}
    return migrated(folder, files)[f"launch/{name}"]


def included(inside: str, name: str = "gazebo") -> str:
    """A launch file in XML that starts Gazebo Classic."""
    head = f'  <include file="$(find-pkg-share gazebo_ros)/launch/{name}.launch.py"'
    return f"<launch>\n{head}>\n{inside}  </include>\n</launch>\n" if inside else f"<launch>\n{head}/>\n</launch>\n"


def started(options: str, more: str) -> str:
    """A launch file in XML that starts gz."""
    return f"""\
<launch>
  <include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py">
    <arg name="gz_args" value="{options}"/>
  </include>
{more}</launch>
"""


CLOCK = """\
  <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"/>
"""


@pytest.mark.parametrize(
    ("inside", "options"),
    [
        ("", "-r empty.sdf"),
        (
            '    <arg name="world" value="$(var world)"/>\n    <arg name="verbose" value="true"/>\n',
            "-r -v4 $(var world)",
        ),
        ('    <arg name="gui" value="false"/>\n', "-r -s empty.sdf"),
        ('    <arg name="pause" value="true"/>\n', "empty.sdf"),
        (
            '    <arg name="gui" value="$(var gui)"/>\n',
            "-r $(eval &quot;'' if '$(var gui)' == 'true' else '-s '&quot;)empty.sdf",
        ),
    ],
)
def test_a_launch_file_in_xml_starts_gz_in_the_same_way(folder: Folder, inside: str, options: str) -> None:
    assert after(folder, "sim.launch.xml", included(inside)) == started(options, CLOCK)


OWN_WORLD = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    own = os.path.join(get_package_share_directory("base"), "worlds", "empty.world")
    gazebo = os.path.join(get_package_share_directory("gazebo_ros"), "launch", "gazebo.launch.py")
    return LaunchDescription([
        DeclareLaunchArgument("world", default_value="empty.world"),
        DeclareLaunchArgument("other", default_value=own),
        IncludeLaunchDescription(gazebo, launch_arguments={"world": LaunchConfiguration("world")}.items()),
    ])
"""


@pytest.mark.parametrize(("world", "count"), [("worlds/empty.world", 2), ("worlds/yard.world", 1)])
def test_the_own_world_of_the_name_of_the_empty_one_is_still_started(folder: Folder, world: str, count: int) -> None:
    own = {f"{world}": '<sdf version="1.6"><world name="w"/></sdf>\n', "launch/sim.launch.py": OWN_WORLD}
    files = {"urdf/base.xacro": base(CONTROL), "config/controllers.yaml": CONTROLLERS, **own}
    assert migrated(folder, files)["launch/sim.launch.py"].count('"empty.world"') == count


PROCESS = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    world = "/worlds/yard.world"
    command = {command}
    return LaunchDescription([ExecuteProcess(cmd=command, output="screen")])
"""


GZ = '"ros2", "launch", "ros_gz_sim", "gz_sim.launch.py"'


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        ("['gazebo', '--verbose', world, '-s', 'libgazebo_ros_factory.so']", f'[{GZ}, ["gz_args:=-r -v4 ", world]]'),
        ("['gzserver', '-u', '-e', 'ode', world]", f'[{GZ}, ["gz_args:=-s ", world]]'),
        ("['gzclient']", f'[{GZ}, ["gz_args:=-g "]]'),
        ("['gazebo_tool', world]", "['gazebo_tool', world]"),
    ],
)
def test_a_process_that_runs_gazebo_runs_the_launch_file_of_gz(folder: Folder, command: str, expected: str) -> None:
    text = after(folder, "sim.launch.py", PROCESS.format(command=command))
    assert f"    command = {expected}\n" in text
    assert ("parameter_bridge" in text) == ("gz" in expected)


@pytest.mark.parametrize(
    ("command", "value"),
    [
        ("['gazebo', world, '-s', 'libgazebo_ros_factory.so']", '["-r ", world]'),
        ("['gazebo']", '"-r empty.sdf"'),
        ("['gzclient']", '"-g"'),
    ],
)
def test_a_process_with_its_command_line_becomes_an_include_of_the_launch_file_of_gz(
    folder: Folder, command: str, value: str
) -> None:
    process = PROCESS.replace("cmd=command", f"cmd={command}").format(command="None")
    text = after(folder, "sim.launch.py", process)
    file = 'PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"])'
    arguments = f'launch_arguments={{"gz_args": {value}}}.items()'
    assert f"IncludeLaunchDescription(PythonLaunchDescriptionSource({file}), {arguments})" in text
    assert "import IncludeLaunchDescription\n" in text


def test_a_command_line_that_is_not_understood_is_left_to_a_person(folder: Folder) -> None:
    command = "['gzserver', world, ' ', str('--lockstep'), ' ', str('--pause')]"
    text = after(folder, "sim.launch.py", PROCESS.format(command=command))
    assert f"    command = {command}\n" in text
    assert "start gz here by gz_sim.launch.py of ros_gz_sim" in text


def test_an_own_launch_file_with_the_name_of_one_of_gazebo_ros_keeps_it(folder: Folder) -> None:
    include = (
        '        IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare("{}"), "/{}.launch.py"])),\n'
    )
    text = after(
        folder,
        "sim.launch.py",
        "from launch import LaunchDescription\n"
        "from launch.actions import IncludeLaunchDescription\n"
        "from launch.launch_description_sources import PythonLaunchDescriptionSource\n"
        "from launch_ros.substitutions import FindPackageShare\n\n\n"
        "def generate_launch_description():\n    return LaunchDescription([\n"
        f"{include.format('base', 'gzserver')}{include.format('gazebo_ros', 'gzclient')}    ])\n",
    )
    assert include.format("base", "gzserver") in text
    assert '[FindPackageShare("ros_gz_sim"), "/gz_sim.launch.py"]' in text


def test_a_process_that_an_event_handler_waits_for_stays_a_process(folder: Folder) -> None:
    waiting = """\
    gazebo = ExecuteProcess(cmd=["gzserver", world])
    handler = RegisterEventHandler(OnProcessStart(target_action=gazebo, on_start=[]))
    return LaunchDescription([gazebo, handler])
"""
    imports = "from launch.actions import RegisterEventHandler\nfrom launch.event_handlers import OnProcessStart\n"
    text = after(folder, "sim.launch.py", imports + PROCESS[: PROCESS.index("    command")] + waiting)
    assert f'gazebo = ExecuteProcess(cmd=[{GZ}, ["gz_args:=-s -r ", world]])' in text


def test_what_is_added_to_a_launch_file_is_indented_by_its_tabs(folder: Folder) -> None:
    source = PROCESS.replace("    return LaunchDescription([", "    ld = LaunchDescription()\n    ld.add_action(")
    source = source.replace('output="screen")])', 'output="screen"))\n    return ld').format(
        command="['gzserver', world]"
    )
    text = after(folder, "sim.launch.py", source.replace("    ", "\t"))
    compile(text, "sim.launch.py", "exec")
    assert "\tld.add_action(Node(" in text


def test_a_launch_file_in_xml_starts_the_bridge_of_the_robots_topics(folder: Folder) -> None:
    shown = after(folder, "sim.launch.xml", included(""), DRIVE)
    node = f'  <node pkg="ros_gz_bridge" exec="parameter_bridge">\n    {BRIDGE}\n  </node>\n'
    assert shown == started("-r empty.sdf", node)


def test_the_window_of_gazebo_classic_becomes_that_of_gz(folder: Folder) -> None:
    assert after(folder, "sim.launch.xml", included("", "gzclient")) == started("-g", CLOCK)


def test_a_robot_is_spawned_without_the_options_that_gz_rejects(folder: Folder) -> None:
    args = "-topic robot_description -entity base -timeout 30 -x $(var x) -unpause"
    old = f'<launch>\n  <node pkg="gazebo_ros" exec="spawn_entity.py" args="{args}"/>\n</launch>\n'
    new = "-topic robot_description -name base -x $(var x)"
    assert after(folder, "spawn.launch.xml", old) == (
        f'<launch>\n  <node pkg="ros_gz_sim" exec="create" args="{new}"/>\n</launch>\n'
    )


def test_a_launch_file_in_yaml_starts_gz_and_spawns_the_robot(folder: Folder) -> None:
    old = """\
launch:
# the simulator
- include:
    file: $(find-pkg-share gazebo_ros)/launch/gazebo.launch.py
    arg:
    - {name: world, value: yard.sdf}
    - {name: verbose, value: "true"}
- node: {pkg: gazebo_ros, exec: spawn_entity.py, args: -topic robot_description -entity base}
"""
    assert (
        after(folder, "sim.launch.yaml", old)
        == """\
launch:
# the simulator
- node: {pkg: ros_gz_bridge, exec: parameter_bridge, args: "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"}
- include:
    file: "$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"
    arg: [{name: gz_args, value: "-r -v4 yard.sdf"}]
- node: {pkg: "ros_gz_sim", exec: "create", args: "-topic robot_description -name base"}
"""
    )


def test_a_launch_file_in_python_keeps_its_window_and_pause_and_drops_options_that_gz_rejects(folder: Folder) -> None:
    shown = after(
        folder,
        "sim.launch.py",
        """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    source = PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gazebo.launch.py"])
    return LaunchDescription([
        IncludeLaunchDescription(source, launch_arguments={"gui": "false", "pause": "true"}.items()),
        Node(
            package="gazebo_ros",
            executable="spawn_entity.py",
            arguments=["-topic", "robot_description", "-entity", "base", "-timeout", "30"],
        ),
    ])
""",
    )
    assert 'launch_arguments={"gz_args": "-s empty.sdf"}' in shown
    assert 'arguments=["-topic", "robot_description", "-name", "base"]' in shown


def test_a_launch_file_in_python_lets_its_user_choose_the_window_as_before(folder: Folder) -> None:
    shown = after(
        folder,
        "sim.launch.py",
        """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    source = PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gzserver.launch.py"])
    window = PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gazebo.launch.py"])
    talk = "true"
    given = {"gui": LaunchConfiguration("gui"), "pause": LaunchConfiguration("pause"), "verbose": talk}
    return LaunchDescription([
        IncludeLaunchDescription(source, launch_arguments={"gui": LaunchConfiguration("gui")}.items()),
        IncludeLaunchDescription(window, launch_arguments=given.items()),
    ])
""",
    )
    assert 'launch_arguments={"gz_args": "-r -s empty.sdf"}.items()' in shown
    pause = """PythonExpression(["'' if '", LaunchConfiguration("pause"), "' == 'true' else '-r '"])"""
    gui = """PythonExpression(["'' if '", LaunchConfiguration("gui"), "' == 'true' else '-s '"])"""
    assert f'given = {{"gz_args": ["-v4 ", {pause}, {gui}, "empty.sdf"]}}' in shown
    assert "from launch.substitutions import PythonExpression\n" in shown


def test_arguments_that_gz_has_not_are_reported(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    source = PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gazebo.launch.py"])
    return LaunchDescription([IncludeLaunchDescription(source, launch_arguments={"physics": "bullet"}.items())])
"""
    files = {"urdf/base.xacro": base(CONTROL), "config/controllers.yaml": CONTROLLERS, "launch/sim.launch.py": launch}
    assert "gz has no argument physics: dropped" in migrated(folder, files)["MIGRATION.md"]


EMPTY_BY_DEFAULT = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare


def start(context):
    world = LaunchConfiguration("map").perform(context)
    file = PythonLaunchDescriptionSource([FindPackageShare("gazebo_ros"), "/launch/gazebo.launch.py"])
    return [IncludeLaunchDescription(file, launch_arguments={"world": world}.items())]


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("map", default_value=""),
            DeclareLaunchArgument("prefix", default_value=""),
            OpaqueFunction(function=start),
        ]
    )
"""


def test_the_empty_default_of_an_argument_for_the_world_is_a_world(folder: Folder) -> None:
    text = after(folder, "base.launch.py", EMPTY_BY_DEFAULT)
    assert 'DeclareLaunchArgument("map", default_value="empty.sdf")' in text
    assert 'DeclareLaunchArgument("prefix", default_value="")' in text
    inside = '    <arg name="world" value="$(var map)"/>\n  '
    in_xml = included(inside).replace("<launch>", '<launch>\n  <arg name="map" default=""/>', 1)
    assert '<arg name="map" default="empty.sdf"/>' in after(folder, "base.launch.xml", in_xml)


DESCRIBED = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare("base")
    text = Command(["xacro ", PathJoinSubstitution([share, "urdf", "base.xacro"])])
    return LaunchDescription([
        IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare("gazebo_ros"), "launch", "gazebo.launch.py"])),
        Node(package="robot_state_publisher", executable="robot_state_publisher", {where}
             parameters=[{{"robot_description": text}}]),
        Node(package="gazebo_ros", executable="spawn_entity.py", arguments=["-topic", "it", "-entity", "base"]),
    ])
"""
RUN_BY_CLASSIC = """\
  <gazebo>
    <plugin name="gazebo_ros2_control" filename="libgazebo_ros2_control.so">
      {inner}<parameters>$(find base)/config/c.yaml</parameters>
    </plugin>
  </gazebo>
"""
IN_FRONT = "<ros>\n        <namespace>front</namespace>\n      </ros>\n      "


@pytest.mark.parametrize(
    ("where", "inner", "expected"),
    [
        ("remappings=[('robot_description', 'it')],", "", "/it"),
        ("namespace='front',", "", "/front/robot_description"),
        ("namespace='front',", IN_FRONT, ""),
        ("remappings=[('robot_description', 'it')],", IN_FRONT, "/it"),
        ("", "", ""),
    ],
)
def test_the_manager_reads_the_description_where_it_is_published(
    folder: Folder, where: str, inner: str, expected: str
) -> None:
    files = {
        "launch/base.launch.py": DESCRIBED.format(where=where),
        "urdf/base.xacro": base(RUN_BY_CLASSIC.format(inner=inner)),
        "config/c.yaml": "controller_manager:\n  ros__parameters:\n    update_rate: 100\n",
    }
    text = migrated(folder, files, "--from", "humble", "--to", "jazzy", "--simulator", "gz")["urdf/base.xacro"]
    assert text.count("<ros>") == bool(expected or inner)
    assert text.count("<remapping>") == bool(expected)
    assert not expected or f"<remapping>robot_description:={expected}</remapping>" in text


PATHS = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    classic = get_package_share_directory("gazebo_ros")
    world = {world}
    server = os.path.join(classic, "launch", "gzserver.launch.py")
    return LaunchDescription([IncludeLaunchDescription(server, launch_arguments={{"world": world}}.items())])
"""


@pytest.mark.parametrize(
    ("world", "new"),
    [
        ('os.path.join(classic, "worlds", "empty.world")', '"empty.sdf"'),
        ('classic + "/worlds/empty.world"', '"empty.sdf"'),
        ('PathJoinSubstitution([FindPackageShare("gazebo_ros"), "worlds", "empty.world"])', '"empty.sdf"'),
        ('os.path.join(classic, "worlds", "shapes.world")', None),
        ('os.path.join(get_package_share_directory("base"), "worlds", "empty.world")', None),
    ],
)
def test_the_path_of_classics_empty_world_becomes_the_name_of_that_of_gz(
    folder: Folder, world: str, new: str | None
) -> None:
    text = after(folder, "sim.launch.py", PATHS.format(world=world))
    assert f"    world = {new or world}\n" in text
    assert '"gz_args": ["-r -s ", world]' in text
