"""Launch files that are joined with no robot: each is named with what is missing."""

from __future__ import annotations

import json
from typing import Any

import pytest
from folder import Folder

MANIFEST = "<package format='3'><name>{}</name><export><build_type>ament_cmake</build_type></export></package>"
SPAWNER = '<node pkg="controller_manager" exec="spawner" args="{}"/>'
SHOWN = '<node pkg="rviz2" exec="rviz2"/>'
PUBLISHER = """<node pkg="robot_state_publisher" exec="robot_state_publisher">
  <param name="robot_description" value="$(command 'xacro $(find-pkg-share hoist)/urdf/{}')" type="str"/></node>"""
HOIST = """<robot name="hoist" xmlns:xacro="http://www.ros.org/wiki/xacro">{}
  <link name="base"/>
  <joint name="lift" type="prismatic"><parent link="base"/><child link="hook"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" effort="9" velocity="1"/></joint>
  <link name="hook"/>
</robot>"""
LOADED = """<launch>
  <rosparam>
    drum: {type: effort_controllers/JointEffortController, joint: drum_joint}
  </rosparam>
  <node name="s" pkg="controller_manager" type="spawner" args="drum"/>
</launch>"""
PYTHON = """
import hoist_helpers
from somewhere import driver_nodes
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare

def start(context):
    return [{}, *driver_nodes()]

def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=start)])
"""
HELPERS = """
from launch_ros.actions import Node

def spawner(name):
    return Node(package={!r}, executable="spawner", arguments=[name])
"""
ABSENT = 'IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare("{}"), "/launch/{}.launch.py"]))'


def xml(*parts: str) -> str:
    return f"<launch>{''.join(parts)}</launch>"


def written(folder: Folder, **launches: str) -> None:
    names = {name: f"{name}.launch.{'xml' if text.startswith('<') else 'py'}" for name, text in launches.items()}
    folder.write({f"launch/{names[name]}": text for name, text in launches.items()})
    folder.write({"package.xml": MANIFEST.format("hoist")})


def unjoined(folder: Folder) -> list[dict[str, Any]]:
    given: list[dict[str, Any]] = json.loads(folder.run("show", ".", "--format", "json").stdout)["unjoined"]
    return given


@pytest.mark.parametrize("format_", ["1", "3"])
def test_a_spawner_without_any_robot_is_named_in_packages_of_each_format(folder: Folder, format_: str) -> None:
    written(folder, up=xml(SPAWNER.format("lift_controller")))
    folder.write({"package.xml": MANIFEST.format("hoist").replace("'3'", f"'{format_}'")})
    ran = folder.run("lint", ".")
    assert ran.returncode == 0, ran.stderr
    reason = "nothing here starts or describes a robot"
    file = "launch/up.launch.xml"
    assert f"1 launch file starts controllers without a robot that fits: {file} ({reason})" in " ".join(
        ran.stdout.split()
    )


def test_launch_files_that_start_neither_robot_nor_controllers_are_nothing_to_lint(folder: Folder) -> None:
    written(folder, up=xml(SHOWN, '<include file="$(find-pkg-share elsewhere_bringup)/launch/robot.launch.py"/>'))
    ran = folder.run("lint", ".")
    assert ran.returncode == 2
    assert "nothing to lint in .: it contains launch files" in ran.stderr


def test_a_start_whose_description_does_not_exist_is_shown_and_is_not_called_unused(folder: Folder) -> None:
    written(folder, up=xml(PUBLISHER.format("hoist.urdf")), down=xml(PUBLISHER.format("hoits.urdf")))
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    absent = "a robot whose description 'urdf/hoits.urdf' does not exist"
    shown = folder.run("show", ".").stdout
    assert f"launch/down.launch.xml  (starts {absent})" in shown
    assert "launch/up.launch.xml\n  description urdf/hoist.urdf\n" in shown
    linted = folder.run("lint", ".").stdout
    assert f"1 launch file starts {absent}: launch/down.launch.xml" in " ".join(linted.split())
    assert "not used by any robot" not in linted


@pytest.mark.parametrize(
    ("include", "reason"),
    [
        ("", "hoist.urdf has no joint 'drum_joint'"),
        ('<xacro:include filename="$(find drums)/drum.xacro"/>', "it is not known to belong to hoist.urdf"),
    ],
)
def test_joints_are_missing_only_from_a_robot_that_is_known_whole(folder: Folder, include: str, reason: str) -> None:
    manifest = "<package format='2'><name>hoist</name><buildtool_depend>catkin</buildtool_depend></package>"
    folder.write({"package.xml": manifest, "hoist.urdf": HOIST.format(include), "launch/up.launch": LOADED})
    assert f"launch/up.launch  (starts controllers without a robot: {reason})" in folder.run("show", ".").stdout


@pytest.mark.parametrize(("package", "status"), [("controller_manager", 0), ("rviz2", 2)])
def test_what_a_module_beside_a_launch_file_starts_counts(folder: Folder, package: str, status: int) -> None:
    written(folder, up=PYTHON.format('hoist_helpers.spawner("lift_controller")'))
    folder.write({"launch/hoist_helpers.py": HELPERS.format(package)})
    ran = folder.run("lint", ".")
    assert ran.returncode == status
    assert ("1 launch file starts controllers without a robot" in ran.stdout) is (status == 0)


@pytest.mark.parametrize(
    ("included", "packages"),
    [(("hoist_bringup", "robot"), ["hoist_bringup"]), (("zed_camera", "start"), [])],
)
def test_what_is_elsewhere_is_named_also_if_more_is_unknown(
    folder: Folder, included: tuple[str, str], packages: list[str]
) -> None:
    written(folder, up=PYTHON.format(ABSENT.format(*included)), show=xml(PUBLISHER.format("h.urdf")))
    folder.write({"urdf/h.urdf": HOIST.format("")})
    assert [name for each in unjoined(folder) for name in each["lacks"]["packages"]] == packages


INCLUDED = '<include file="$(find {})/launch/franka_control.launch"/>'
CONTROL = '<rosparam>drum: {{type: own/Drum}}</rosparam><node name="s" pkg="controller_manager" type="spawner" {}/>'


@pytest.mark.parametrize(
    ("package", "expected"), [("arm_moveit_config", []), ("realsense_camera", ["launch/up.launch"])]
)
def test_controllers_of_a_robot_that_is_started_elsewhere_are_not_joined_by_their_names_alone(
    folder: Folder, package: str, expected: list[str]
) -> None:
    manifest = "<package format='2'><name>hoist</name><buildtool_depend>catkin</buildtool_depend></package>"
    up = xml(INCLUDED.format(package), CONTROL.format('args="drum"'))
    folder.write({"package.xml": manifest, "hoist.urdf": HOIST.format(""), "launch/up.launch": up})
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [each["launch"] for each in shown["targets"] if each["launch"]] == expected


def test_a_leftover_of_ros_1_leaves_no_empty_line(folder: Folder) -> None:
    written(folder)
    folder.write(
        {"launch/up.launch": '<launch><node name="s" pkg="controller_manager" type="spawner" args="a"/></launch>'}
    )
    assert "\n\n\n" not in folder.run("lint", ".").stdout


@pytest.mark.parametrize(
    ("name", "expected"), [("robot_description_hoist", ["launch/up.launch"]), ("robot_description_semantic", [])]
)
def test_a_parameter_with_a_longer_name_that_is_spawned_is_a_robot(
    folder: Folder, name: str, expected: list[str]
) -> None:
    manifest = "<package format='2'><name>hoist</name><buildtool_depend>catkin</buildtool_depend></package>"
    described = f'<param name="{name}" command="$(find xacro)/xacro $(find hoist)/hoist.urdf"/>'
    spawned = f'<node pkg="gazebo_ros" name="s" type="spawn_model" args="-urdf -model hoist -param {name}"/>'
    folder.write({"package.xml": manifest, "hoist.urdf": HOIST.format(""), "launch/up.launch": xml(described, spawned)})
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [each["launch"] for each in shown["targets"] if each["launch"]] == expected


@pytest.mark.parametrize(
    "node",
    [
        '<node pkg="robot_state_publisher" exec="robot_state_publisher" args="{}"/>',
        '<node pkg="ros_gz_sim" exec="create" args="-file {} -name hoist"/>',
    ],
)
def test_a_description_that_an_argument_names_in_another_package_is_named(folder: Folder, node: str) -> None:
    here, elsewhere = "$(find-pkg-share hoist)/hoist.urdf", "$(find-pkg-share derrick_description)/urdf/derrick.urdf"
    written(folder, up=xml(node.format(here)), down=xml(node.format(elsewhere)))
    folder.write({"hoist.urdf": HOIST.format("")})
    found = [(each["launch"], each["lacks"]["packages"]) for each in unjoined(folder)]
    assert found == [("launch/down.launch.xml", ["derrick_description"])]


def test_an_argument_in_another_package_for_another_program_is_no_robot(folder: Folder) -> None:
    viewed = '<node pkg="urdf_viewer" exec="view" args="$(find-pkg-share derrick_description)/urdf/derrick.urdf"/>'
    written(folder, up=xml(PUBLISHER.format("hoist.urdf")), down=xml(viewed))
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    assert unjoined(folder) == []


OPENED = """
import yaml
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    chosen = yaml.safe_load(open('/etc/hoist.yaml'))['model']
    given = {{'robot_description': open(chosen).read()}}
    return LaunchDescription([Node(package={!r}, executable={!r}, parameters=[given])])
"""
CREATED = '<node pkg="ros_gz_sim" exec="create" args="-file $(find-pkg-share hoist)/{} -name hoist"/>'


def told(folder: Folder) -> list[str]:
    return [line for line in folder.run("show", ".").stdout.splitlines() if not line.startswith(" ")]


def test_a_robot_whose_description_cannot_be_determined_is_named(folder: Folder) -> None:
    written(folder, up=OPENED.format("robot_state_publisher", "robot_state_publisher"))
    assert told(folder) == ["launch/up.launch.py  (starts a robot whose description could not be determined)"]


def test_lint_names_it_too_where_there_is_nothing_else(folder: Folder) -> None:
    written(folder, up=OPENED.format("robot_state_publisher", "robot_state_publisher"))
    manifest = MANIFEST.format("hoist").replace("<export>", "<exec_depend>robot_state_publisher</exec_depend><export>")
    folder.write({"package.xml": manifest})
    ran = folder.run("lint", ".")
    named = "1 launch file starts a robot whose description could not be determined: launch/up.launch.py"
    assert (ran.returncode, named in " ".join(ran.stdout.split())) == (0, True)


def test_a_description_that_only_a_viewer_gets_starts_no_robot(folder: Folder) -> None:
    written(folder, up=OPENED.format("rviz2", "rviz2"))
    assert told(folder) == []


def test_a_model_of_the_simulator_is_named_where_no_description_is_started(folder: Folder) -> None:
    written(folder, up=xml(CREATED.format("hoist.sdf")))
    folder.write({"hoist.sdf": "<sdf version='1.9'><model name='hoist'/></sdf>"})
    assert told(folder) == ["launch/up.launch.xml  (starts a model from 'hoist.sdf'; models in SDF are not checked)"]


def test_a_description_that_is_spawned_is_no_model_of_the_simulator(folder: Folder) -> None:
    written(folder, up=xml(PUBLISHER.format("hoist.urdf"), CREATED.format("urdf/hoist.urdf")))
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    assert told(folder) == ["launch/up.launch.xml"]


def test_launch_files_that_are_not_here_are_named_beside_the_robot(folder: Folder) -> None:
    abroad = '<include file="$(find-pkg-share derrick_driver)/launch/driver.launch.xml"/>'
    written(folder, up=xml(PUBLISHER.format("hoist.urdf"), abroad))
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    shown = folder.run("show", ".").stdout
    assert "  unknown     launch files of derrick_driver, not in this workspace" in shown


PLANNED = """
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node
from moveit_configs_utils import MoveItConfigsBuilder

def generate_launch_description():
    path = get_package_share_directory("derrick_support") + "/urdf/derrick.urdf.xacro"
    config = MoveItConfigsBuilder("hoist", package_name="hoist").robot_description(file_path=path).to_moveit_configs()
    return LaunchDescription([Node(package="moveit_ros_move_group", executable="move_group",
                                   parameters=[config.to_dict()])])
"""


def test_a_description_that_moveit_takes_from_a_package_that_is_not_here_is_named(folder: Folder) -> None:
    written(folder, plan=PLANNED)
    assert [each["lacks"]["packages"] for each in unjoined(folder)] == [["derrick_support"]]


UNKNOWN_ROBOT = """
from somewhere import described
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[{}]),
        Node(package="controller_manager", executable="spawner", arguments=["states"]),
    ])
"""


@pytest.mark.parametrize("parameters", ["described()", "described"])
def test_a_launch_file_that_publishes_a_robot_of_its_own_is_not_started_beside_another_one(
    parameters: str, folder: Folder
) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format(""), "urdf/lift.urdf": HOIST.format("")})
    full = xml(PUBLISHER.format("hoist.urdf"), SPAWNER.format("states"))
    up = UNKNOWN_ROBOT.format(parameters)
    written(folder, full=full, show=xml(PUBLISHER.format("lift.urdf"), SHOWN), up=up)
    reason = "starts controllers without a robot: its description could not be determined"
    assert [line for line in told(folder) if "(" in line] == [f"launch/up.launch.py  ({reason})"]


def test_a_launch_file_whose_description_is_not_known_has_that_of_the_only_robot_of_its_package(
    folder: Folder,
) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    written(folder, show=xml(PUBLISHER.format("hoist.urdf"), SHOWN), up=UNKNOWN_ROBOT.format("described()"))
    assert unjoined(folder) == []
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)["targets"]
    starts = [(one["robot"], one["beside"], one["spawned"]) for one in shown if one["launch"] == "launch/up.launch.py"]
    assert starts == [("urdf/hoist.urdf", [], ["states"])]


ABSENT_PARTS = """<robot name="hoist" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find drum_description)/urdf/drum.urdf.xacro"/></robot>"""


def test_controllers_belong_to_the_only_robot_of_their_package_also_if_its_parts_are_not_here(folder: Folder) -> None:
    folder.write({"urdf/hoist.urdf": ABSENT_PARTS, "urdf/lift.urdf": ABSENT_PARTS})
    written(folder, show=xml(PUBLISHER.format("hoist.urdf"), SHOWN), up=xml(SPAWNER.format("states")))
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert shown["unjoined"] == []
    assert [(one["robot"], one["beside"]) for one in shown["targets"] if one["launch"]] == [
        ("urdf/hoist.urdf", ["launch/up.launch.xml"])
    ]
    for other in (PUBLISHER.format("lift.urdf"), PUBLISHER.format("hoist.urdf") + SPAWNER.format("drum")):
        written(folder, show=xml(other, SHOWN), again=xml(PUBLISHER.format("hoist.urdf"), SPAWNER.format("winch")))
        assert [one["launch"] for one in unjoined(folder)] == ["launch/up.launch.xml"]


def test_what_a_launch_file_includes_that_is_named_itself_is_neither_a_robot_nor_unused(folder: Folder) -> None:
    loading = '<rosparam file="$(find hoist)/drum.yaml"/>'
    control = xml(loading, '<node name="s" pkg="controller_manager" type="spawner" args="drum"/>')
    lost = '<param name="robot_description" command="xacro $(find drum_description)/drum.urdf"/>'
    outer = xml(lost, '<include file="$(find hoist)/launch/control.launch"/>')
    declared = "drum: {type: effort_controllers/JointEffortController, joint: drum_joint}"
    manifest = MANIFEST.format("hoist").replace("ament_cmake", "catkin")
    folder.write({"hoist/package.xml": manifest, "hoist/drum.yaml": declared})
    folder.write({"hoist/launch/control.launch": control, "hoist/launch/world.launch": outer})
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert [one["launch"] for one in shown["unjoined"]] == ["hoist/launch/world.launch"]
    assert (shown["targets"], shown["unused"]) == ([], [])


def test_parameter_files_that_are_not_here_are_named_beside_the_robot(folder: Folder) -> None:
    manager = """<node pkg="controller_manager" exec="ros2_control_node">
      <param from="$(find-pkg-share derrick_control)/config/controllers.yaml"/></node>"""
    written(folder, up=xml(PUBLISHER.format("hoist.urdf"), manager))
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    shown = folder.run("show", ".").stdout
    assert "  unknown     parameter files of derrick_control, not in this workspace\n" in shown
    abroad = '<include file="$(find-pkg-share derrick_driver)/launch/driver.launch.xml"/>'
    written(folder, up=xml(PUBLISHER.format("hoist.urdf"), manager, abroad))
    both = "launch files of derrick_driver and parameter files of derrick_control, not in this workspace"
    assert f"  unknown     {both}\n" in folder.run("show", ".").stdout


@pytest.mark.parametrize("package", ["hoist", "$(var robot)"])
def test_a_parameter_file_that_could_not_be_determined_is_told_beside_the_robot(package: str, folder: Folder) -> None:
    manager = f"""<node pkg="controller_manager" exec="ros2_control_node">
      <param from="$(find-pkg-share {package})/drum.yaml"/></node>"""
    written(folder, up=xml('<arg name="robot"/>', PUBLISHER.format("hoist.urdf"), manager))
    folder.write({"urdf/hoist.urdf": HOIST.format(""), "drum.yaml": "drum: {ros__parameters: {joint: hook}}"})
    unnamed = "  unknown     some parameter files that the launch file loads could not be determined\n"
    assert (unnamed in folder.run("show", ".").stdout) is (package != "hoist")


MANAGED = """
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from moveit_configs_utils import MoveItConfigsBuilder

def generate_launch_description():
    config = MoveItConfigsBuilder("hoist", package_name="hoist").robot_description("urdf/lift.urdf").to_moveit_configs()
    shown = {{"robot_description": Command(["xacro ", FindPackageShare("hoist"), "/urdf/hoist.urdf"])}}
    return LaunchDescription([
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[shown]),
        Node(package="controller_manager", executable="ros2_control_node", parameters=[{}]),
    ])
"""


@pytest.mark.parametrize("parameters", ["config.to_dict()", "config.robot_description"])
def test_a_manager_that_gets_all_parameters_of_moveit_gets_the_description_too(parameters: str, folder: Folder) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format(""), "urdf/lift.urdf": HOIST.format("")})
    written(folder, up=MANAGED.format(parameters))
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)["targets"]
    assert [one["robot"] for one in shown if one["launch"]] == ["urdf/lift.urdf"]


WORLD = '<include file="$(find-pkg-share gazebo_ros)/launch/gazebo.launch.py"/>'
PUT = '<node pkg="gazebo_ros" exec="spawn_entity.py" args="-topic robot_description -entity hoist"/>'


@pytest.mark.parametrize(
    ("parts", "starts"),
    [
        ((WORLD,), None),
        ((WORLD, PUT), "a robot whose description could not be determined"),
        ((WORLD, SPAWNER.format("states")), "controllers without a robot"),
    ],
)
def test_a_simulator_without_a_robot_starts_no_controllers(
    parts: tuple[str, ...], starts: str | None, folder: Folder
) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format(""), "urdf/lift.urdf": HOIST.format("")})
    shown = {name: xml(PUBLISHER.format(f"{name}.urdf"), SHOWN) for name in ("hoist", "lift")}
    written(folder, **shown, up=xml(*parts))
    named = [line for line in told(folder) if "up.launch.xml" in line]
    assert [line.partition(":")[0].rstrip(")") for line in named] == (
        [f"launch/up.launch.xml  (starts {starts}"] if starts else []
    )


def test_show_says_which_start_spawns_the_controllers_of_a_launch_file_without_a_robot(folder: Folder) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    whole = xml(PUBLISHER.format("hoist.urdf"), SPAWNER.format("states"))
    written(folder, whole=whole, up=xml(SPAWNER.format("states")))
    assert "launch/up.launch.xml  (launch/whole.launch.xml spawns its controllers)" in told(folder)
    shown = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert shown["covered"] == [{"launch": "launch/up.launch.xml", "by": "launch/whole.launch.xml"}]
    assert (shown["unjoined"], shown["unused"]) == ([], [])
    written(folder, up=xml(SPAWNER.format("winch")))
    again = json.loads(folder.run("show", ".", "--format", "json").stdout)
    assert again["covered"] == []


def test_a_launch_file_whose_robot_is_started_elsewhere_is_no_part_of_one_that_spawns_the_same(folder: Folder) -> None:
    folder.write({"urdf/hoist.urdf": HOIST.format("")})
    whole = xml(PUBLISHER.format("hoist.urdf"), SPAWNER.format("states"))
    abroad = '<include file="$(find-pkg-share {})/launch/{}.launch.xml"/>'
    written(folder, whole=whole, up=xml(abroad.format("derrick_bringup", "derrick"), SPAWNER.format("states")))
    absent = "launch files that it includes are in package 'derrick_bringup', not in this workspace"
    assert f"launch/up.launch.xml  (starts controllers without a robot: {absent})" in told(folder)
    written(folder, up=xml(abroad.format("slam_toolbox", "slam"), SPAWNER.format("states")))
    assert "launch/up.launch.xml  (launch/whole.launch.xml spawns its controllers)" in told(folder)


READ_HERE = """
from launch import LaunchDescription
from launch.substitutions import Command, PathJoinSubstitution
from launch_ros.actions import Node

def generate_launch_description():
    described = Command(["xacro ", PathJoinSubstitution(["./", "hoist.urdf"])])
    return LaunchDescription([Node(package="robot_state_publisher", executable="robot_state_publisher",
                                   parameters=[{"robot_description": described}])])
"""


def test_a_relative_path_is_that_of_the_file_beside_the_launch_file(folder: Folder) -> None:
    written(folder, up=READ_HERE)
    named = ["launch/up.launch.py  (starts a robot whose description could not be determined)"]
    assert told(folder) == named
    folder.write({"hoist.urdf": HOIST.format("")})  # the folder in which launch is started is not known
    assert [line for line in told(folder) if "up.launch" in line] == named
    folder.write({"launch/hoist.urdf": HOIST.format("")})
    assert "launch/up.launch.py\n  description launch/hoist.urdf\n" in folder.run("show", ".").stdout


CATKIN = "<package format='2'><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
DRUM = '<node name="s" pkg="controller_manager" type="spawner" args="drum"/>'


@pytest.mark.parametrize(
    ("file", "nodes", "said"),
    [
        ("hoist)/launch/bringup.launch", "", "launch file 'launch/bringup.launch', which does not exist"),
        ("hoist)/launch/robot.launch", "", "launch file 'launch/robot.launch', which cannot be read"),
        (
            "hoist)/launch/$(arg a)_robot.launch",
            "",
            "launch file 'launch/*_robot.launch', which depends on an argument",
        ),
        ("hoist)/launch/robot.launch", DRUM, "launch file 'launch/robot.launch' that it includes cannot be read"),
        ("derrick)/launch/robot.launch", "", "launch files of package 'derrick', not in this workspace"),
    ],
)
def test_an_included_launch_file_that_cannot_be_read_is_named_and_not_its_package(
    file: str, nodes: str, said: str, folder: Folder
) -> None:
    shows = '<node name="p" pkg="robot_state_publisher" type="robot_state_publisher"/>'
    up = f'<launch><arg name="a" default="$(env A)"/><include file="$(find {file}"/>{shows}{nodes}</launch>'
    folder.write({"package.xml": CATKIN.format("hoist"), "launch/up.launch": up, "launch/robot.launch": "<launch>"})
    ran = folder.run("show", ".").stdout
    assert [said in line for line in ran.splitlines() if line.startswith("launch/up.launch")] == [True]
    lacks = [each["lacks"] for each in unjoined(folder) if each["launch"] == "launch/up.launch"]
    included, packages = (None, ["derrick"]) if "derrick" in file else (said.split("'")[1], [])
    assert [(each.get("included"), each["packages"]) for each in lacks] == [(included, packages)]


def test_parameter_files_of_a_package_that_is_here_are_not_said_to_be_elsewhere(folder: Folder) -> None:
    load = '<rosparam file="$(find {})/config/$(arg a).yaml"/>'
    described = '<param name="robot_description" textfile="$(find hoist)/hoist.urdf"/>'
    up = f'<launch><arg name="a" default="$(env A)"/>{described}{load}</launch>'
    folder.write({"package.xml": CATKIN.format("hoist"), "hoist.urdf": HOIST.format("")})
    elsewhere = "  unknown     parameter files of derrick, not in this workspace"
    unnamed = "  unknown     some parameter files that the launch file loads could not be determined"
    for name, told_of in (("hoist", [unnamed]), ("derrick", [elsewhere])):
        folder.write({"launch/up.launch": up.format(name)})
        lines = folder.run("show", ".").stdout.splitlines()
        assert [line for line in lines if "parameter files" in line] == told_of


OF_ENVIRONMENT = """
import os
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node

def generate_launch_description():
    described = Command(["xacro ", os.environ["MODEL"], ".urdf"])
    return LaunchDescription([Node(package="robot_state_publisher", executable="robot_state_publisher",
                                   parameters=[{"robot_description": described}])])
"""


def test_the_environment_variable_that_a_description_depends_on_is_named(folder: Folder) -> None:
    written(folder, up=OF_ENVIRONMENT)
    why = "depends on environment variable 'MODEL'; give it with --env"
    assert told(folder) == [f"launch/up.launch.py  (starts a robot whose description {why})"]
    assert [each["lacks"]["variables"] for each in unjoined(folder)] == [["MODEL"]]


def test_an_included_launch_file_is_started_alone_though_another_package_has_one_of_its_name(folder: Folder) -> None:
    described = '<launch><param name="robot_description" textfile="$(find {0})/{0}.urdf"/></launch>'
    for name in ("hoist", "lift"):
        folder.write({f"{name}/package.xml": CATKIN.format(name), f"{name}/{name}.urdf": HOIST.format("")})
        folder.write({f"{name}/robot.launch": described.format(name)})
    never = '<launch><group if="false"><include file="$(find lift)/robot.launch"/></group></launch>'
    folder.write({"hoist/never.launch": never})
    assert told(folder) == ["hoist/robot.launch", "lift/robot.launch"]


DISPLAYED = """
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

def generate_launch_description():
    given = {{"urdf_package": "hoist", {} "rviz_config": "x.rviz"}}
    return LaunchDescription([IncludeLaunchDescription(
        PathJoinSubstitution([FindPackageShare("urdf_launch"), "launch", "{}.launch.py"]),
        launch_arguments=given.items())])
"""
FILE = '"urdf_package_path": PathJoinSubstitution(["urdf", "hoist.urdf"]),'


@pytest.mark.parametrize(
    ("given", "file", "found"),
    [(FILE, "display", True), (FILE, "description", True), ("", "display", False), (FILE, "other", False)],
)
def test_urdf_launch_publishes_the_description_that_its_arguments_name(
    given: str, file: str, found: bool, folder: Folder
) -> None:
    written(folder, up=DISPLAYED.format(given, file))
    folder.write({"urdf/hoist.urdf": HOIST.format("<!-- lift: heavy -->")})
    assert "UC632" not in folder.run("lint", ".").stdout
    assert ("launch/up.launch.py\n  description urdf/hoist.urdf\n" in folder.run("show", ".").stdout) is found


def test_a_description_that_may_be_made_later_is_named_where_it_was_not_found(folder: Folder) -> None:
    folder.write({".gitignore": "made/\n", "package.xml": CATKIN.format("hoist")})
    described = '<param name="robot_description" textfile="$(find hoist)/made/hoist.urdf"/>'
    folder.write({"launch/up.launch": f"<launch>{described}</launch>"})
    assert told(folder) == ["launch/up.launch  (starts a robot whose description 'made/hoist.urdf' was not found)"]
    folder.write({"launch/up.launch": f"<launch>{described}{DRUM}</launch>"})
    reason = "controllers without a robot: its description 'made/hoist.urdf' was not found"
    assert told(folder) == [f"launch/up.launch  (starts {reason})"]


def test_a_robot_of_another_package_that_has_nothing_of_it_is_not_named(folder: Folder) -> None:
    for name, text in (("hoist", xml(PUBLISHER.format("hoist.urdf"))), ("drum", LOADED)):
        ending = "launch" if "rosparam" in text else "launch.xml"
        manifest = CATKIN if name == "drum" else MANIFEST
        folder.write({f"{name}/package.xml": manifest.format(name), f"{name}/launch/up.{ending}": text})
    folder.write({"hoist/urdf/hoist.urdf": HOIST.format(""), "lift/package.xml": CATKIN.format("lift")})
    lift = '<launch><param name="robot_description" textfile="$(find lift)/lift.urdf"/></launch>'
    folder.write({"lift/lift.urdf": HOIST.format(""), "lift/launch/show.launch": lift})
    named = [line for line in told(folder) if line.startswith("drum/")]
    reason = "controllers without a robot: no robot here has joint 'drum_joint'"
    assert named == [f"drum/launch/up.launch  (starts {reason})"]


@pytest.mark.parametrize(
    ("given", "packages"), [("$(find hoist)/hoist.urdf", ["derrick"]), ("$(find hoist)/hoist.yaml", []), ("lift", [])]
)
def test_a_launch_file_that_is_not_here_starts_the_robot_whose_description_it_is_given(
    given: str, packages: list[str], folder: Folder
) -> None:
    argument = f'<arg name="robot_description" value="{given}"/>'
    up = f'<launch><include file="$(find derrick)/launch/go.launch">{argument}</include></launch>'
    folder.write({"package.xml": CATKIN.format("hoist"), "launch/up.launch": up, "hoist.urdf": HOIST.format("")})
    named = [each["lacks"]["packages"] for each in unjoined(folder) if each["launch"] == "launch/up.launch"]
    assert named == ([packages] if packages else [])
