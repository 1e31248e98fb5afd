"""What becomes of the parameters, remappings and variables that a launch file of ROS 1 gives to nodes."""

from __future__ import annotations

import textwrap

import pytest
from folder import Folder
from ros1_packages import EFFORT, PLUGIN, arm, migrated, transmission

ROBOT = arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN)
ONE_NODE = """\
<launch>
  <node name="states" pkg="joint_state_publisher" type="joint_state_publisher">
{more}
  </node>
</launch>
"""
CONTROL = '<launch><node name="mover" pkg="arm" type="mover.py"/></launch>\n'
NAMED = """\
<launch>
  <param name="mux/rate" value="30.0"/>
  <group ns="mux">
    <param name="topics/frame" value="odom"/>
    <rosparam>limits: [1, 2]</rosparam>
  </group>
  <param name="other" value="1"/>
  <node name="mux" pkg="twist_mux" type="twist_mux"/>
</launch>
"""
FILTER = """\
<launch>
  <node name="filter" pkg="robot_localization" type="ekf_localization_node">
    <rosparam command="load" file="$(find arm)/config/filter.yaml"{more}/>
  </node>
</launch>
"""
SCOPED = """\
<launch>
  <group>
    <env name="GAZEBO_MODEL_PATH" value="$(find arm)/models"/>
    <remap from="scan" to="/front/scan"/>
    <node name="mux" pkg="twist_mux" type="twist_mux"/>
  </group>
</launch>
"""


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ('<param name="rate" type="double" value="50"/>', '"rate": 50.0'),
        ('<param name="/~serial" type="str" value="0012"/>', '"serial": "0012"'),
        ("<rosparam param='source_list'>[/arm/joint_states]</rosparam>", '"source_list": ["/arm/joint_states"]'),
        ("<rosparam ns='zeros'>\n  a: 1\n  b:\n    c: [1, 2.5]\n</rosparam>", '"zeros.a": 1, "zeros.b.c": [1.0, 2.5]'),
        (
            "<rosparam param='l' subst_value='true'>[/$(arg arm)/states]</rosparam>",
            r'"l": ["[\"/", LaunchConfiguration("arm"), "/states\"]"]',
        ),
        ("<rosparam>{names: ['1', two], on: [true, False]}</rosparam>", '"names": ["1", "two"], "on": [True, False]'),
    ],
)
def test_parameters_of_a_node_keep_their_values_and_types(folder: Folder, written: str, expected: str) -> None:
    after = migrated(folder, {"launch/arm.launch": ONE_NODE.format(more=written)})
    assert expected in " ".join(after["launch/arm.launch.py"].split())


def test_a_parameter_that_is_the_text_of_a_file_is_left_to_a_person(folder: Folder) -> None:
    node = '<node name="a" pkg="arm" type="a"><param name="script" textfile="$(find arm)/a.txt"/></node>'
    after = migrated(folder, {"launch/arm.launch": f"<launch>{node}</launch>"})
    assert "# TODO(urdfctl): give node 'a' its parameter 'script'" in after["launch/arm.launch.py"]


def test_remappings_in_the_arguments_of_a_node_are_its_own(folder: Folder) -> None:
    """ROS 1 takes them out of the command line; a node of ROS 2 would read them as plain words."""
    args = "raw in:=$(arg from)/image out:=/new _rate:=5 __name:=other plain.txt"
    node = f'<launch><arg name="from" default="eye"/><node name="n" pkg="arm" type="n.py" args="{args}"/></launch>'
    text = " ".join(migrated(folder, {"launch/arm.launch": node})["launch/arm.launch.py"].split())
    assert 'name="other"' in text
    assert 'arguments=["raw", "plain.txt"]' in text
    assert 'parameters=[{"rate": 5}]' in text
    assert 'remappings=[("in", [LaunchConfiguration("from"), "/image"]), ("out", "/new")]' in text


@pytest.mark.parametrize("program", ["gzserver", "gzclient"])
def test_a_remapping_of_the_simulator_is_left_to_a_person(folder: Folder, program: str) -> None:
    """It reached the controllers in it, and those of gz have no node of a launch file."""
    node = f'<node name="g" pkg="gazebo_ros" type="{program}"><remap from="/c/command" to="motor"/></node>'
    files = {"launch/sim.launch": f"<launch>{node}</launch>", "config/c.yaml": EFFORT, "arm.xacro": ROBOT}
    text = migrated(folder, files)["launch/sim.launch.py"]
    assert ("the remapping of '/c/command' to 'motor' reached the controllers" in text) is (program == "gzserver")


def test_parameters_that_are_set_by_the_name_of_a_node_are_given_to_it(folder: Folder) -> None:
    text = migrated(folder, {"launch/arm.launch": NAMED})["launch/arm.launch.py"]
    assert 'parameters=[{"rate": 30.0, "topics.frame": "odom", "limits": [1, 2]}]' in text
    assert text.count("TODO(urdfctl)") == 1
    assert "ROS 2 has no global parameters: give 'other'" in text


def test_the_file_with_the_parameters_of_a_node_gets_the_form_of_ros_2(folder: Folder) -> None:
    files = {"launch/arm.launch": FILTER.format(more=""), "config/filter.yaml": "# slow\nfrequency: 30.0  # Hz\n"}
    after = migrated(folder, files)
    assert after["config/filter.yaml"] == "# slow\n/**:\n  ros__parameters:\n    frequency: 30.0  # Hz\n"
    assert (
        'parameters=[ParameterFile([FindPackageShare("arm"), "/config/filter.yaml"])]' in after["launch/arm.launch.py"]
    )


def test_a_package_that_launch_or_xacro_looks_for_is_told_if_it_may_not_exist(folder: Folder) -> None:
    included = '<xacro:include filename="$(find {})/urdf/hand.xacro"/>\n'
    robot = arm(transmission("EffortJointInterface"), included.format("arm") + included.format("hand_description"))
    launch = """\
<launch>
  <!-- $(find old_tools)/a.yaml -->
  <arg name="world" default="$(find hall_worlds)/hall.world"/>
  <arg name="limits" default="$(find fake_localization)/limits.yaml"/>
  <node name="rviz" pkg="rviz" type="rviz" args="-d $(find urdf_tutorial)/urdf.rviz"/>
</launch>
"""
    after = migrated(folder, {"urdf/arm.xacro": robot, "urdf/hand.xacro": "<robot/>", "launch/arm.launch": launch})
    told = [line for line in after["MIGRATION.md"].splitlines() if "looks for it" in line]
    assert [line.partition(": ")[2].partition(":")[0] for line in told] == [
        "check that package 'hall_worlds' exists for jazzy",
        "no distro of ROS 2 has package 'fake_localization'",
        "check that package 'hand_description' exists for jazzy",
    ]


def test_a_file_of_a_description_that_ros_2_has_with_other_files_is_told(folder: Folder) -> None:
    files = ("ur_description)/urdf/ur7.urdf.xacro", "velodyne_description)/urdf/VLP-16.urdf.xacro", "arm)/urdf/a.xacro")
    included = "".join(f'<xacro:include filename="$(find {file}"/>\n' for file in files)
    robot = arm(transmission("EffortJointInterface"), included)
    report = migrated(folder, {"urdf/arm.xacro": robot, "urdf/a.xacro": "<robot/>"})["MIGRATION.md"]
    assert "check that 'ur_description' of jazzy has 'urdf/ur7.urdf.xacro', with what the simulator needs" in report
    assert "VLP-16" not in report
    assert "'urdf/a.xacro', with" not in report


def test_an_integer_is_a_double_where_the_node_of_ros_2_declares_one(folder: Folder) -> None:
    inside = '<param name="yaw_offset" value="0"/><param name="zero_altitude" value="true"/>'
    node = f'<node name="gps" pkg="robot_localization" type="navsat_transform_node">{inside}</node>'
    after = migrated(folder, {"launch/arm.launch": f"<launch>{node}</launch>\n"})
    assert '"yaw_offset": 0.0, "zero_altitude": True' in after["launch/arm.launch.py"]
    assert "check that package" not in after["MIGRATION.md"]


def test_a_file_is_found_from_the_folder_of_its_launch_file(folder: Folder) -> None:
    launch = FILTER.format(more="").replace("$(find arm)/config", "$(dirname)/../config")
    after = migrated(folder, {"launch/arm.launch": launch, "config/filter.yaml": "frequency: 30\n"})
    assert after["config/filter.yaml"] == "/**:\n  ros__parameters:\n    frequency: 30.0\n"
    assert 'ParameterFile([ThisLaunchFileDir(), "/../config/filter.yaml"])' in after["launch/arm.launch.py"]


def test_a_file_that_ros_2_cannot_read_as_parameters_is_left_to_a_person(folder: Folder) -> None:
    after = migrated(folder, {"launch/arm.launch": FILTER.format(more=""), "config/filter.yaml": "a:\n- {b: 1}\n"})
    assert after["config/filter.yaml"].startswith("# TODO(urdfctl): write these parameters below ros__parameters")
    assert after["config/filter.yaml"].endswith("\na:\n- {b: 1}\n")


def test_a_file_that_is_loaded_below_a_name_is_left_to_a_person(folder: Folder) -> None:
    files = {"launch/arm.launch": FILTER.format(more=' ns="local"'), "config/filter.yaml": "frequency: 30.0\n"}
    first, rest = migrated(folder, files)["config/filter.yaml"].split("\n", 1)
    assert first.endswith(": a launch file of ROS 1 loads them below another name")
    assert rest == "frequency: 30.0\n"


def test_a_file_of_a_node_that_ros_2_does_not_have_stays(folder: Folder) -> None:
    launch = FILTER.format(more="").replace("robot_localization", "move_base")
    files = {"launch/arm.launch": launch, "config/filter.yaml": "frequency: 30.0\n"}
    assert migrated(folder, files)["config/filter.yaml"] == "frequency: 30.0\n"


ANALYZED = """\
analyzers:
  motors:
    type: diagnostic_aggregator/GenericAnalyzer
    path: Motors
"""


def test_the_plugins_of_a_node_are_not_taken_for_controllers(folder: Folder) -> None:
    node = 'pkg="diagnostic_aggregator" type="aggregator_node"'
    launch = FILTER.format(more="").replace('pkg="robot_localization" type="ekf_localization_node"', node)
    after = migrated(folder, {"launch/arm.launch": launch, "config/filter.yaml": ANALYZED})
    assert after["config/filter.yaml"] == "/**:\n  ros__parameters:\n" + textwrap.indent(ANALYZED, "    ")
    assert "write the analyzers directly below ros__parameters" in after["MIGRATION.md"]


def test_controllers_that_a_node_of_ones_own_manages_are_still_controllers(folder: Folder) -> None:
    launch = FILTER.format(more="").replace("robot_localization", "arm")
    controllers = "ctl:\n  type: effort_controllers/JointEffortController\n  joint: shoulder\n"
    after = migrated(folder, {"launch/arm.launch": launch, "config/filter.yaml": controllers})["config/filter.yaml"]
    assert "controller_manager" in after


IN_PYTHON = """\
SetEnvironmentVariable("GZ_SIM_RESOURCE_PATH", [FindPackageShare("arm"), "/models"]), \
SetRemap(src="scan", dst="/front/scan"),"""
IN_XML = """\
<set_env name="GZ_SIM_RESOURCE_PATH" value="$(find-pkg-share arm)/models"/> \
<set_remap from="scan" to="/front/scan"/>"""


PREFIXED = """\
<launch>
  <arg name="tf_prefix" default=""/>
  <arg name="prefix" value="$(arg tf_prefix)/" if="$(eval tf_prefix != '')"/>
  <arg name="prefix" value="" unless="$(eval tf_prefix != '')"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/arm.xacro"/>
  <rosparam file="$(find arm)/config/c.yaml" command="load" subst_value="true"/>
  <node name="s" pkg="controller_manager" type="spawner" args="ctl"/>
</launch>
"""


def test_arguments_in_a_controller_file_become_their_values_by_default(folder: Folder) -> None:
    file = "# $(arg prefix)\nctl:\n  type: effort_controllers/JointEffortController\n  joint: $(arg prefix)shoulder\n"
    robot = arm(transmission("EffortJointInterface"))
    files = {"launch/arm.launch": PREFIXED, "config/c.yaml": file, "urdf/arm.xacro": robot}
    after = migrated(folder, files)
    assert "# $(arg prefix)\nctl:\n  ros__parameters:\n    joints: [shoulder]\n" in after["config/c.yaml"]
    assert "'$(arg prefix)' became '', its value by default" in after["MIGRATION.md"]


@pytest.mark.parametrize(("form", "expected"), [("py", IN_PYTHON), ("xml", IN_XML)])
def test_variables_and_remappings_apply_to_the_nodes_after_them(folder: Folder, form: str, expected: str) -> None:
    after = migrated(folder, {"launch/arm.launch": SCOPED}, "--simulator", "gz", "--launch", form)
    text = " ".join(after[f"launch/arm.launch.{form}"].split())
    assert expected in text
    assert "TODO" not in text


@pytest.mark.parametrize(
    ("written", "in_python", "in_xml"),
    [
        (
            "prefix != ''",
            """PythonExpression(["'", LaunchConfiguration("prefix"), "' != ''"])""",
            "$(eval &quot;'$(var prefix)' != ''&quot;)",
        ),
        (
            "'arm_' + arg('prefix').split('_')[1]",
            """PythonExpression(["'arm_' + '", LaunchConfiguration("prefix"), "'.split('_')[1]"])""",
            "$(eval &quot;'arm_' + '$(var prefix)'.split('_')[1]&quot;)",
        ),
        (
            "not gui and arg('n') > 3",
            """PythonExpression(["not ('", LaunchConfiguration("gui"), "'.lower() == 'true') and ", \
LaunchConfiguration("n"), " > 3"])""",
            "$(eval &quot;not ('$(var gui)'.lower() == 'true') and $(var n) &gt; 3&quot;)",
        ),
        (
            "gui == true and pi > 3",
            """PythonExpression(["('", LaunchConfiguration("gui"), "'.lower() == 'true') == True and pi > 3"])""",
            "$(eval &quot;('$(var gui)'.lower() == 'true') == True and pi &gt; 3&quot;)",
        ),
        (
            "find('arm') + optenv('SIDE', 'left')",
            """PythonExpression(["'", FindPackageShare("arm"), "' + '", \
EnvironmentVariable("SIDE", default_value="left"), "'"])""",
            "$(eval &quot;'$(find-pkg-share arm)' + '$(env SIDE 'left')'&quot;)",
        ),
        (
            "optenv('FILE', find('arm') + '/a.yaml')",
            """PythonExpression(["('", EnvironmentVariable("FILE", default_value=""), "' or ('", \
FindPackageShare("arm"), "' + '/a.yaml'))"])""",
            "$(eval &quot;('$(env FILE '')' or ('$(find-pkg-share arm)' + '/a.yaml'))&quot;)",
        ),
        (
            "max(1, len(str(arg('prefix'))))",
            """PythonExpression(["max(1, len(str('", LaunchConfiguration("prefix"), "')))"])""",
            "$(eval &quot;max(1, len(str('$(var prefix)')))&quot;)",
        ),
    ],
)
def test_expressions_get_the_text_of_their_arguments(folder: Folder, written: str, in_python: str, in_xml: str) -> None:
    arguments = "".join(f'<arg name="{name}" default="1"/>' for name in ("prefix", "gui", "n"))
    node = f'<node name="a" pkg="arm" type="a" if="$(eval {written.replace(">", "&gt;")})"/>'
    launch = {"launch/arm.launch": f"<launch>{arguments}{node}</launch>"}
    assert f"condition=IfCondition({in_python})" in migrated(folder, launch)["launch/arm.launch.py"]
    assert f'if="{in_xml}"' in migrated(folder, launch, "--launch", "xml")["launch/arm.launch.xml"]


@pytest.mark.parametrize("written", ["$(find arm)/config/a.yaml", "$(find arm)config/a.yaml"])
def test_a_path_in_a_package_does_not_need_a_slash_in_roslaunch(folder: Folder, written: str) -> None:
    node = f'<node name="a" pkg="arm" type="a" args="-f {written} $(find arm) end"/>'
    text = migrated(folder, {"launch/arm.launch": f"<launch>{node}</launch>"})["launch/arm.launch.py"]
    assert '[FindPackageShare("arm"), "/config/a.yaml"], FindPackageShare("arm"), "end", ]' in " ".join(text.split())


def test_a_parameter_that_has_another_name_in_ros_2_is_named(folder: Folder) -> None:
    joy = '<node pkg="joy" type="joy_node" name="joy"><param name="dev" value="/dev/input/js0"/></node>'
    text = migrated(folder, {"launch/arm.launch": f"<launch>{joy}</launch>"})["launch/arm.launch.py"]
    assert "node 'joy' ignores parameter 'dev' in ROS 2: give it device_id (0 for js0) or device_name" in text
    other = joy.replace("joy", "arm").replace("arm_node", "mover")
    assert "ignores" not in migrated(folder, {"launch/arm.launch": f"<launch>{other}</launch>"})["launch/arm.launch.py"]


REMAPPED = """\
<launch>
  <remap from="joint_states" to="arm/joint_states"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <remap from="other" to="arm/other"/>
</launch>
"""


@pytest.mark.parametrize("has_controllers", [True, False])
def test_a_remapping_around_the_simulator_is_named_for_its_controllers(folder: Folder, has_controllers: bool) -> None:
    files = {"launch/arm.launch": REMAPPED, "urdf/arm.xacro": arm(transmission("EffortJointInterface"))}
    files |= {"config/c.yaml": "ctl:\n  type: effort_controllers/JointEffortController\n"} if has_controllers else {}
    text = migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"]
    assert ("the remapping of 'joint_states' to 'arm/joint_states' reached the controllers" in text) is has_controllers
    assert "the remapping of 'other'" not in text


@pytest.mark.parametrize(
    ("value", "lost"), [("-s libmine.so", "-s libmine.so"), ("$(arg more)", "--verbose"), ("$(arg none)", ""), ("", "")]
)
def test_an_argument_of_gazebo_classic_that_gz_has_not_is_named(folder: Folder, value: str, lost: str) -> None:
    arguments = '<arg name="more" default="--verbose"/><arg name="none" default=""/>'
    given = f'<arg name="extra_gazebo_args" value="{value}"/><arg name="physics" value="ode"/>'
    world = f'<include file="$(find gazebo_ros)/launch/empty_world.launch">{given}</include>'
    files = {"launch/arm.launch": f"<launch>{arguments}{world}</launch>", "urdf/arm.urdf": arm("")}
    text = migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"]
    assert (f"gz has no argument 'extra_gazebo_args': what '{lost}' did" in text) is bool(lost)
    assert "gz has no argument 'physics'" not in text


@pytest.mark.parametrize(
    ("args", "expected"),
    [
        ("pub /ready std_msgs/Bool true", '"/ready", "std_msgs/msg/Bool", "{data: true}"'),
        ("pub -1 -l /level std_msgs/Float64 0.5", '"--once", "/level", "std_msgs/msg/Float64", "{data: 0.5}"'),
    ],
)
def test_a_node_that_publishes_a_topic_from_the_command_line_is_a_command_of_ros_2(
    folder: Folder, args: str, expected: str
) -> None:
    launch = f'<launch>\n  <node name="p" pkg="rostopic" type="rostopic" args="{args}"/>\n</launch>\n'
    text = " ".join(migrated(folder, {"launch/a.launch": launch})["launch/a.launch.py"].split())
    words = text[text.index("ExecuteProcess(") :].replace("[ ", "[").replace(", ]", "]")
    assert words.startswith(f'ExecuteProcess(cmd=["ros2", "topic", "pub", {expected}])') or expected in words


def test_another_command_of_ros_1_is_left_to_a_person_and_does_not_end_the_launch(folder: Folder) -> None:
    launch = '<launch>\n  <node name="b" pkg="rosbag" type="record" args="-a"/>\n</launch>\n'
    after = migrated(folder, {"launch/a.launch": launch})
    assert "Node(" not in after["launch/a.launch.py"]
    assert "'record -a' is a command of ROS 1" in after["MIGRATION.md"]


def test_launch_files_that_are_started_with_a_simulator_have_its_time(folder: Folder) -> None:
    world = '  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>\n'
    launch = f'<launch>\n{world}  <include file="$(find arm)/launch/b.launch"/>\n</launch>\n'
    files = {"launch/a.launch": launch, "launch/b.launch": ONE_NODE.format(more="")}
    text = migrated(folder, files, "--simulator", "gz")["launch/a.launch.py"]
    assert 'SetParameter(name="use_sim_time", value=True)' in text


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ({}, True),
        ({"src/hardware.cpp": "controller_manager::ControllerManager manager(&robot);\n"}, False),
        ({"launch/c.launch": '<launch><param name="use_sim_time" value="$(optenv SIM true)"/></launch>\n'}, False),
        ({"launch/a.launch": CONTROL.replace('pkg="arm"', 'pkg="arm_driver"')}, False),
        ({"launch/a.launch": CONTROL.replace("mover.py", "other.py")}, False),
        ({"config/c.yaml": EFFORT.replace("ctl:", "left:")}, False),
    ],
)
def test_a_launch_file_that_commands_a_simulated_robot_has_the_time_of_the_simulator(
    folder: Folder, more: dict[str, str], expected: bool
) -> None:
    """It is started after that of the simulator, which set the time for all nodes of ROS 1."""
    program = '#!/usr/bin/env python\nTOPIC = "/arm/ctl/command"\n'
    files = {"arm.xacro": ROBOT, "config/c.yaml": EFFORT, "scripts/mover.py": program, "launch/a.launch": CONTROL}
    after = migrated(folder, {**files, **more}, "--simulator", "gz")
    assert ('SetParameter(name="use_sim_time", value=True)' in after["launch/a.launch.py"]) == expected


def test_nodes_beside_the_spawner_of_a_simulated_robot_have_the_time_of_the_simulator(folder: Folder) -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="ctl"/>'
    launch = f'<launch><rosparam file="$(find arm)/config/c.yaml"/>{spawner}{{}}</launch>\n'
    files = {"arm.xacro": ROBOT, "config/c.yaml": EFFORT, "launch/a.launch": launch.format("")}
    files["launch/b.launch"] = launch.format('<node name="t" pkg="arm" type="t.py"/>')
    after = migrated(folder, files, "--simulator", "gz")
    assert "use_sim_time" not in after["launch/a.launch.py"]
    assert 'SetParameter(name="use_sim_time", value=True)' in after["launch/b.launch.py"]


def test_a_program_that_an_argument_chooses_stays_one(folder: Folder) -> None:
    node = '<node name="s" pkg="arm" type="$(arg kind)"/>'
    launch = {"launch/a.launch": f'<launch>\n  <arg name="kind" default="sdk"/>\n  {node}\n</launch>\n'}
    assert 'executable=LaunchConfiguration("kind")' in migrated(folder, launch)["launch/a.launch.py"]
    assert 'exec="$(var kind)"' in migrated(folder, launch, "--launch", "xml")["launch/a.launch.xml"]


def test_a_file_of_another_form_is_not_taken_for_that_of_the_bridge(folder: Folder) -> None:
    plugin = '<plugin name="imu" filename="libgazebo_ros_imu_sensor.so"><topicName>imu</topicName></plugin>'
    imu = f'<gazebo reference="upper"><sensor name="imu" type="imu">{plugin}</sensor></gazebo>\n'
    manifest = "<package format='2'><name>wires</name><buildtool_depend>catkin</buildtool_depend></package>"
    world = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'
    files = {
        "urdf/arm.xacro": arm(transmission("EffortJointInterface"), imu),
        "launch/sim.launch": f"<launch>\n  {world}\n</launch>\n",
        "wires/package.xml": manifest,
        "wires/config/bridge.yaml": "topics: [a]\n",
    }
    text = migrated(folder, files, "--simulator", "gz")["launch/sim.launch.py"]
    assert '"config_file": [FindPackageShare("arm"), "/config/bridge.yaml"]' in text


@pytest.mark.parametrize(
    ("world", "is_told"),
    [
        ("worlds/$(arg place).world", True),
        ("worlds/mud.world", True),
        ("worlds/hall.world", False),
        ("$(find arm)/worlds/hall.world", False),
        ("worlds/empty.world", False),
    ],
)
def test_a_world_that_came_with_gazebo_classic_is_told(folder: Folder, world: str, is_told: bool) -> None:
    launch = f"""\
<launch>
  <arg name="place" default="mud"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"><arg name="world_name" value="{world}"/></include>
</launch>
"""
    own = '<sdf version="1.6"><world name="hall"/></sdf>\n'
    files = {"urdf/arm.urdf.xacro": ROBOT, "launch/sim.launch": launch, "worlds/hall.world": own}
    report = migrated(folder, files)["MIGRATION.md"]
    assert ("gz has none of the worlds that Gazebo Classic came with" in report) == is_told
