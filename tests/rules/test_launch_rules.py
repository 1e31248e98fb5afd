"""The rules on launch files, on whole small packages; Python, XML and YAML, of ROS 1 and ROS 2."""

from __future__ import annotations

from textwrap import dedent

import pytest
import robots
from folder import Folder
from launched_packages import found, ros1

from urdfctl.control.parameters.spawner_options import MODEL_SOURCES
from urdfctl.rules import launch_samples as samples
from urdfctl.rules.launch_samples import (
    ARM,
    BROADCASTER,
    CONTROLLERS,
    FILE,
    MANAGER,
    PUBLISHER,
    launched,
    spawner,
)


def test_the_sound_package_is_silent_by_all_rules_for_each_distro(folder: Folder) -> None:
    for distro in ("humble", "jazzy", "rolling"):
        assert found(folder, samples.SOUND, "UC", distro=distro) == []


# -- what is spawned -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("program", "source"), [(program, each) for program, sources in MODEL_SOURCES.items() for each in sources]
)
def test_a_model_is_spawned_from_each_source_that_the_program_has(folder: Folder, program: str, source: str) -> None:
    package = "ros_gz_sim" if program == "create" else "gazebo_ros"
    kind = 'name="model" type' if program == "spawn_model" else "exec"
    node = f'<node pkg="{package}" {kind}="{program}" args="{{}} -x 1"/>'

    def told(option: str) -> list[str]:
        nodes = [node.format(option)]
        files = ros1(*nodes) if program == "spawn_model" else launched(PUBLISHER, *nodes)
        return [message for _, _, message in found(folder, files, "UC624") if "not told what to spawn" in message]

    assert told(f"-{source} robot_description") == []
    assert told(f"-{source}=robot_description") == []
    assert len(told("")) == 1
    assert len(told("-y -0.5 -z -.5")) == 1


def test_a_controller_is_looked_for_in_the_namespace_of_its_manager(folder: Folder) -> None:
    there = [part.replace("<node ", '<node namespace="left" ') for part in (MANAGER, ARM)]
    files = launched(PUBLISHER, *there)
    assert found(folder, files, "UC601") == [
        ("UC601", "error", "controller 'arm_controller' is spawned in namespace '/left', but declared in '/'"),
    ]
    anywhere = CONTROLLERS.replace("    controller_manager:", "    /**/controller_manager:")
    assert found(folder, launched(PUBLISHER, *there, controllers=anywhere), "UC601") == []


def test_of_a_name_that_is_like_no_other_the_declared_ones_are_told(folder: Folder) -> None:
    assert found(folder, launched(MANAGER, spawner(f"gripper {FILE}")), "UC601") == [
        (
            "UC601",
            "error",
            (
                "controller 'gripper' is spawned, but no file declares it; "
                "declared: 'arm_controller' and 'joint_state_broadcaster'"
            ),
        ),
    ]


@pytest.mark.parametrize(
    "nodes",
    [
        (spawner("gripper"),),
        (MANAGER, spawner("gripper -t p/Gripper")),
        (MANAGER.replace("</node>", '<param name="gripper.type" value="p/Gripper"/></node>'), spawner("gripper")),
        (MANAGER, '<include file="$(env NOWHERE)"/>', spawner("gripper")),
        (MANAGER.replace("controllers.yaml", "other.yaml"), spawner("gripper")),
    ],
    ids=["no manager", "its type is given", "the manager is told", "something included", "a file that is not there"],
)
def test_nothing_is_said_of_controllers_that_something_else_may_declare(folder: Folder, nodes: tuple[str, ...]) -> None:
    assert found(folder, launched(*nodes), "UC601") == []


def test_of_ros_1_what_a_launch_file_loads_is_all_there_is(folder: Folder) -> None:
    node = '<node name="s" pkg="controller_manager" type="spawner" args="{}"/>'
    controllers = "arm: {type: position_controllers/JointPositionController, joint: elbow}"
    assert found(folder, ros1(node.format("hand"), controllers=controllers), "UC601") == [
        ("UC601", "error", "controller 'hand' is spawned, but no file declares it; declared: 'arm'"),
    ]
    assert found(folder, ros1(node.format("arm"), controllers=controllers), "UC601") == []
    both = [("UC601", "error", "controller 'arms' is spawned, but no file declares it; declared: 'arm'")]
    assert found(folder, ros1(node.format("arms arm"), controllers=controllers), "UC601") == both


@pytest.mark.parametrize(
    ("more", "severity"),
    [
        ((MANAGER,), "info"),
        ((MANAGER, '<include file="$(find-pkg-share ros_gz_sim)/launch/gz_sim.launch.py"/>'), "error"),
        ((), "info"),
    ],
)
def test_gazebo_loses_no_link_of_a_robot_that_a_launch_file_starts_without_it(
    folder: Folder, more: tuple[str, ...], severity: str
) -> None:
    tool = '<link name="tool"><visual><geometry><sphere radius="1"/></geometry></visual></link>'
    tool += '<joint name="wrist" type="continuous"><parent link="fore"/><child link="tool"/></joint>'
    files = launched(PUBLISHER, *more, robot=samples.ROBOT + tool)
    assert [one[1] for one in found(folder, files, "UC133")] == [severity]


def test_a_spawner_that_only_other_arguments_start_makes_a_warning(folder: Folder) -> None:
    sometimes = spawner("gripper").replace("<node ", '<node if="$(env WHAT)" ')
    assert [one[1] for one in found(folder, launched(MANAGER, sometimes), "UC601")] == ["warning"]


def test_what_a_command_loads_and_then_activates_is_not_spawned_twice(folder: Folder) -> None:
    command = '<executable cmd="ros2 control set_controller_state arm_controller active"/>'
    assert found(folder, launched(MANAGER, ARM, command), "UC602") == []
    unknown = ARM.replace("<node ", '<node namespace="$(env WHERE)" ')
    assert found(folder, launched(MANAGER, unknown, ARM), "UC602") == []


def test_controllers_that_are_alternatives_are_told_of_in_one_finding(folder: Folder) -> None:
    gripper = "        gripper:\n          type: p/Gripper\n        arm_controller:"
    more = CONTROLLERS.replace("        arm_controller:", gripper, 1)
    nodes = (PUBLISHER, MANAGER, spawner("joint_state_broadcaster"))
    assert found(folder, launched(*nodes, controllers=more), "UC603") == [
        (
            "UC603",
            "warning",
            (
                "controllers 'gripper' and 'arm_controller' are configured but not spawned by the launch file, "
                "which spawns only broadcasters: no joint moves"
            ),
        ),
    ]
    slip = spawner("grippr")
    assert [one[2] for one in found(folder, launched(*nodes, slip, controllers=more), "UC603")] == [
        "controller 'arm_controller' is configured but not spawned by the launch file"
    ]
    elsewhere = spawner("gripper arm_controller").replace("<node ", '<node if="false" ')
    assert found(folder, launched(*nodes, elsewhere, controllers=more), "UC603") == []


# -- the states of joints --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "inside",
    [
        '<param name="source_list" value="x"/>',
        '<remap from="joint_states" to="other"/>',
        '<param from="$(env FILE)"/>',
    ],
)
def test_joint_state_publisher_may_be_told_to_publish_something_else(folder: Folder, inside: str) -> None:
    node = f'<node pkg="joint_state_publisher" exec="joint_state_publisher">{inside}</node>'
    assert found(folder, launched(MANAGER, BROADCASTER, ARM, node), "UC604") == []
    assert found(folder, launched(MANAGER, spawner("joint_state_broadcaster --inactive"), node), "UC604") == []


@pytest.mark.parametrize("distro", ["noetic", "jazzy"])
def test_a_launch_file_of_the_other_generation_is_not_judged(folder: Folder, distro: str) -> None:
    node = '<node name="s" pkg="controller_manager" type="spawner" args="--stopped arm"/>'
    files = ros1(node, robot='<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>')
    if distro == "noetic":
        files = launched(PUBLISHER, spawner("--stopped arm_controller", "spawner.py"))
    codes = ("UC605", "UC606", "UC607", "UC608", "UC609", "UC610", "UC611", "UC612", "UC613")
    assert found(folder, files, *codes, distro=distro) == []


# -- managers --------------------------------------------------------------------------------------------------------

CONTROL = """
    <gazebo>
      <plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
        <parameters>$(find arm)/controllers.yaml</parameters>
        {}
      </plugin>
    </gazebo>
"""


@pytest.mark.parametrize(
    "other",
    [
        '<node pkg="arm_driver" exec="driver"/>',
        '<executable cmd="gz sim -r empty.sdf"/>',
        '<include file="$(env NOWHERE)"/>',
    ],
    ids=["a driver", "a simulator", "something included"],
)
def test_a_manager_may_run_in_what_is_not_known(folder: Folder, other: str) -> None:
    assert found(folder, launched(PUBLISHER, ARM, other), "UC605", "UC606") == []
    strange = spawner(f"arm_controller -c /left/controller_manager {FILE}")
    if "gz" not in other:
        assert found(folder, launched(PUBLISHER, MANAGER, strange, other), "UC606") == []


def test_without_the_robot_the_spawner_may_be_for_any(folder: Folder) -> None:
    assert found(folder, launched(ARM), "UC605") == []
    command = '<executable cmd="ros2 control load_controller arm_controller"/>'
    assert found(folder, launched(PUBLISHER, command), "UC605") == []


def test_the_manager_of_a_simulator_s_plugin_runs_where_the_plugin_says(folder: Folder) -> None:
    robot = samples.ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    left = CONTROL.format("<ros><namespace>left</namespace></ros>")
    gz = '<executable cmd="gz sim -r empty.sdf"/>'
    files = {**launched(PUBLISHER, gz, ARM, robot=robot + left)}
    message = (
        "the spawner contacts '/controller_manager', but the running controller manager is '/left/controller_manager'"
    )
    assert found(folder, files, "UC605", "UC606") == [("UC606", "error", message)]
    asked = spawner(f"arm_controller -c /left/controller_manager {FILE}")
    assert found(folder, launched(PUBLISHER, gz, asked, robot=robot + left), "UC606") == []
    placed = '<node pkg="gazebo_ros" exec="spawn_entity.py" args="-entity arm -robot_namespace left"/>'
    assert found(folder, launched(PUBLISHER, gz, placed, ARM, robot=robot + left), "UC606") == []
    ros1 = '<gazebo><plugin filename="libgazebo_ros_control.so" name="p"/></gazebo>'
    assert found(folder, launched(PUBLISHER, MANAGER, ARM, robot=samples.ROBOT + ros1), "UC606") == []


def test_a_second_manager_in_another_namespace_is_for_another_robot(folder: Folder) -> None:
    robot = samples.ROBOT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    manager = MANAGER.replace("<node ", '<node namespace="left" ')
    assert found(folder, launched(PUBLISHER, manager, robot=robot), "UC607") == []
    assert [one[1] for one in found(folder, launched(PUBLISHER, MANAGER, robot=robot), "UC607")] == ["error"]


# -- the spawner's program and options -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("distro", "severity"), [(None, ["warning"]), ("humble", ["error"]), ("galactic", []), ("foxy", [])]
)
def test_spawner_py_is_told_of_by_distro(folder: Folder, distro: str | None, severity: list[str]) -> None:
    files = launched(MANAGER, spawner("arm_controller", "spawner.py"))
    assert [one[1] for one in found(folder, files, "UC608", distro=distro)] == severity


def test_the_unspawner_and_the_verbs_of_foxy_are_called_otherwise_too(folder: Folder) -> None:
    verb = '<executable cmd="ros2 control load_start_controller arm_controller"/>'
    files = launched(MANAGER, spawner("arm_controller", "unspawner.py"), verb)
    assert [one[2] for one in found(folder, files, "UC608", distro="jazzy")] == [
        "'unspawner.py' does not exist in humble and later; use 'unspawner'",
        "'load_start_controller' does not exist in galactic and later; use 'load_controller --set-state active'",
    ]


@pytest.mark.parametrize(
    ("args", "distro", "expected"),
    [
        ("--stopped", "jazzy", [("error", "the spawner has no option '--stopped'; use '--inactive'")]),
        ("--stopped", "humble", []),
        ("--inactive", None, []),
        ("--inactive", "foxy", [("error", "the spawner has no option '--inactive'")]),
        ("--controller-manager-time 5", "jazzy", []),
        ("--wait", "jazzy", [("error", "the spawner has no option '--wait'")]),
        ("--load-onyl", "jazzy", [("error", "the spawner has no option '--load-onyl'; did you mean '--load-only'?")]),
        (
            "-t p/T",
            None,
            [
                (
                    "warning",
                    "the spawner has no option '-t' in jazzy to rolling; set the type in the parameter file",
                )
            ],
        ),
        ("--ros-args -r __ns:=/left", "jazzy", []),
    ],
)
def test_options_are_those_of_the_distro(
    folder: Folder, args: str, distro: str | None, expected: list[tuple[str, str]]
) -> None:
    files = launched(MANAGER, spawner(f"arm_controller {args}"))
    assert [one[1:] for one in found(folder, files, "UC609", distro=distro)] == expected


@pytest.mark.parametrize(("distro", "told"), [(None, ["info"]), ("jazzy", []), ("kilted", []), ("rolling", ["error"])])
def test_parameters_reach_a_controller_by_its_spawner_alone_since_lyrical(
    folder: Folder, distro: str | None, told: list[str]
) -> None:
    files = launched(MANAGER, BROADCASTER, spawner("arm_controller"))
    assert [one[1] for one in found(folder, files, "UC610", distro=distro)] == told
    given = spawner("arm_controller --controller-ros-args '--params-file x.yaml'")
    assert found(folder, launched(MANAGER, given), "UC610", distro=distro) == []
    named = CONTROLLERS.replace("TrajectoryController\n", "TrajectoryController\n          params_file: x.yaml\n")
    assert found(folder, launched(MANAGER, spawner("arm_controller"), controllers=named), "UC610") == []


# -- descriptions ----------------------------------------------------------------------------------------------------

BARE = MANAGER.replace('<remap from="~/robot_description" to="/robot_description"/>', "")


@pytest.mark.parametrize(
    ("publisher", "manager", "distro", "expected"),
    [
        (PUBLISHER, BARE, "jazzy", []),
        (
            "",
            BARE,
            "jazzy",
            [
                (
                    "warning",
                    "no node in the launch file publishes '/robot_description', which the controller manager waits for",
                )
            ],
        ),
        (
            PUBLISHER,
            BARE,
            "humble",
            [
                (
                    "error",
                    "the controller manager gets no robot description, neither as a parameter nor through a remapping",
                )
            ],
        ),
        (PUBLISHER, MANAGER, "humble", []),
        (PUBLISHER, BARE.replace("</node>", '<param name="robot_description" value="x"/></node>'), "humble", []),
        (PUBLISHER, BARE.replace("</node>", '<remap from="robot_description" to="/d"/></node>'), None, []),
        (PUBLISHER, BARE.replace("<node ", '<node namespace="$(env WHERE)" '), "jazzy", []),
        (
            PUBLISHER,
            BARE.replace("</node>", '<remap from="robot_description" to="/d"/></node>'),
            "humble",
            [
                (
                    "error",
                    "the controller manager gets no robot description, neither as a parameter nor through a remapping",
                )
            ],
        ),
    ],
)
def test_the_manager_needs_a_description(
    folder: Folder, publisher: str, manager: str, distro: str | None, expected: list[tuple[str, str]]
) -> None:
    files = launched(publisher, manager)
    assert [one[1:] for one in found(folder, files, "UC611", distro=distro)] == expected


def test_a_publisher_that_something_unknown_is_given_may_publish_anything(folder: Folder) -> None:
    publisher = PUBLISHER.replace("<node ", '<node if="$(env WHAT)" namespace="left" ')
    assert [one[1] for one in found(folder, launched(publisher, BARE), "UC611", distro="jazzy")] == ["warning"]
    nowhere = '<include file="$(env NOWHERE)"/>'
    assert found(folder, launched(BARE, nowhere), "UC611", distro="jazzy") == []
    everywhere = '<set_remap from="robot_description" to="x"/>'
    assert found(folder, launched(everywhere, PUBLISHER, BARE), "UC611", distro="humble") == []


def test_a_simulation_that_runs_or_is_waited_for_longer_is_right(folder: Folder) -> None:
    gz = '<executable cmd="gz sim {} empty.sdf"/>'
    assert found(folder, launched(gz.format("-r"), ARM), "UC612") == []
    patient = spawner(f"arm_controller --switch-timeout 60 {FILE}")
    assert found(folder, launched(gz.format(""), patient), "UC612") == []
    assert [one[0] for one in found(folder, launched(gz.format("-v4"), ARM), "UC612")] == ["UC612"]


def test_the_simulated_robot_s_description_is_looked_for_upwards(folder: Folder) -> None:
    plugin = '<gazebo><plugin name="c" filename="libgazebo_ros_control.so">{}</plugin></gazebo>'
    there = plugin.format("<robotNamespace>/arm</robotNamespace>")
    assert found(folder, ros1(robot=there), "UC613") == []
    assert found(folder, ros1(robot=plugin.format("")), "UC613") == []
    below = {**ros1(robot=plugin.format("<robotNamespace>/</robotNamespace>"))}
    below["arm.launch"] = (
        below["arm.launch"].replace("<param ", '<group ns="x"><param ').replace('urdf"/>', 'urdf"/></group>')
    )
    assert [one[2] for one in found(folder, below, "UC613")] == [
        "the robot description is in '/x', but the controller manager looks for it in '/'",
    ]
    below["arm.launch"] = below["arm.launch"].replace("<group", '<include file="$(env NOWHERE)"/><group')
    assert found(folder, below, "UC613") == []


# -- arguments of launch files ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "told"),
    [('<arg name="side" value="left"/>', 0), ("", 1)],
)
def test_a_default_is_performed_only_where_the_argument_is_not_given(folder: Folder, given: str, told: int) -> None:
    include = f'<include file="$(find-pkg-share arm)/inner.launch.xml">{given}</include>'
    inner = '<launch><arg name="side" default="$(var name)"/></launch>'
    files = {**launched(include, PUBLISHER, MANAGER, BROADCASTER, ARM), "inner.launch.xml": inner}
    message = """argument 'name' is not declared, and has no default; add <arg name="name" default="…"/> before it"""
    assert found(folder, files, "UC630") == [("UC630", "error", message)] * told


# -- arguments of the description ------------------------------------------------------------------------------------


def test_an_argument_that_the_description_does_not_declare_is_reported_where_the_launch_file_gives_it(
    folder: Folder,
) -> None:
    robot = """
        <robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
          <xacro:arg name="prefix" default=""/>
          <link name="$(arg prefix)base"/>
        </robot>
    """
    command = "$(find xacro)/xacro $(find arm)/arm.xacro prefx:=$(arg side)"
    in_ros1 = f"""
        <launch>
          <arg name="side" default="left_"/>
          <param name="robot_description" command="{command}"/>
        </launch>
    """
    in_ros2 = """
        import os
        from ament_index_python.packages import get_package_share_directory
        from launch import LaunchDescription
        from launch.substitutions import Command
        from launch_ros.actions import Node

        def generate_launch_description():
            path = os.path.join(get_package_share_directory("arm"), "arm.xacro")
            text = Command(["xacro ", path, " prefx:=", "left_"])
            node = Node(package="robot_state_publisher", executable="robot_state_publisher",
                        parameters=[{"robot_description": text}])
            return LaunchDescription([node])
    """
    for name, text in (("arm.launch", in_ros1), ("arm.launch.py", in_ros2)):
        files = {name: text, "arm.xacro": robot, "package.xml": "<package><name>arm</name></package>"}
        folder.write({file: dedent(content).strip("\n") + "\n" for file, content in files.items()})
        [one] = robots.findings(name, ("UC021",), workspace=str(folder.path))
        assert (
            one.message == "argument 'prefx' is given, but the description does not declare it; did you mean 'prefix'?"
        )
        assert (folder.path / name).read_bytes()[one.at.start : one.at.end].decode().strip(' "').startswith("prefx:=")
        assert [note.at.file for note in one.notes if note.at] == [str(folder.path / "arm.xacro")]


# -- managers of ROS 1 -----------------------------------------------------------------------------------------------

IN_GAZEBO = """
    <launch>
      <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
      <param name="robot_description" textfile="$(find arm)/robot.urdf"/>
      <node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>
      <node name="spawner" pkg="controller_manager" type="spawner" args="arm"/>%s
    </launch>
"""
FOREIGN = '\n<include file="$(find foreign)/launch/more.launch"/>'


@pytest.mark.parametrize("namespace", ["", "<robotNamespace>/left</robotNamespace>"])
def test_an_included_file_that_is_not_here_makes_a_warning_that_names_it(folder: Folder, namespace: str) -> None:
    plugin = f'<gazebo><plugin name="c" filename="libgazebo_ros_control.so">{namespace}</plugin></gazebo>'
    files = {"robot.urdf": plugin if namespace else "", "package.xml": "<package><name>arm</name></package>"}
    sure = found(folder, {"arm.launch": IN_GAZEBO % "", **files}, "UC643", "UC525", distro="noetic")
    assert [severity for _, severity, _ in sure] == ["error"]
    found(folder, {"arm.launch": IN_GAZEBO % FOREIGN, **files}, "UC643", "UC525", distro="noetic")
    [doubtful] = robots.findings("arm.launch", ("UC643", "UC525"), workspace=str(folder.path), distro="noetic")
    assert doubtful.severity.value == "warning"
    assert "this file cannot be read here" in doubtful.notes[-1].message


LOADED = """
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    with open(os.path.join(get_package_share_directory("arm"), "arm.yaml")) as file:
        values = yaml.safe_load(file)
    return LaunchDescription([Node(package="arm", executable="arm", parameters=[values])])
"""


@pytest.mark.parametrize(
    ("text", "codes"), [("a:\n\tb: 1\n", ["UC026"]), ("a:\n  b: 1\n", []), ("a: {{ b }}: c\n", [])]
)
def test_yaml_that_a_launch_file_loads_is_checked(text: str, codes: list[str], folder: Folder) -> None:
    manifest = "<package format='3'><name>arm</name></package>"
    files = {"arm.launch.py": LOADED, "arm.yaml": text, "package.xml": manifest}
    assert [one[0] for one in found(folder, files, "UC0")] == codes
