"""The description that a node of a migrated launch file has, where several parameters set one in ROS 1."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import arm, migrated, transmission

PARAM = '<param name="{name}" command="$(find xacro)/xacro $(find arm)/urdf/{file}.xacro"{more}/>'
PUBLISHER = '<node pkg="robot_state_publisher" type="robot_state_publisher" name="rsp"/>'
SPAWN = '<node pkg="gazebo_ros" type="spawn_model" name="s" args="-urdf -model arm -param {}"/>'


def param(file: str, more: str = "", name: str = "robot_description") -> str:
    return PARAM.format(name=name, file=file, more=more)


def launched(folder: Folder, *lines: str) -> str:
    launch = f'<launch><arg name="real" default="false"/>{"".join(lines)}</launch>'
    robot = arm(transmission("EffortJointInterface"))
    files = {"launch/arm.launch": launch, "urdf/one.xacro": robot, "urdf/two.xacro": robot}
    after = migrated(folder, files, "--simulator", "gz")
    return " ".join(after["launch/arm.launch.py"].split())


IF_REAL = (' if="$(arg real)"', ' unless="$(arg real)"')
IN_GROUPS = ['<group if="$(arg real)">{}</group>', '<group unless="$(arg real)">{}</group>']


@pytest.mark.parametrize("publisher", ["", PUBLISHER])
@pytest.mark.parametrize(
    "params",
    [
        [param("one", IF_REAL[0]), param("two", IF_REAL[1])],
        [IN_GROUPS[0].format(param("one")), IN_GROUPS[1].format(param("two"))],
    ],
)
def test_each_condition_has_its_own_description(folder: Folder, params: list[str], publisher: str) -> None:
    text = launched(folder, *params, publisher)
    assert text.count('executable="robot_state_publisher"') == 2
    first, _, second = text.partition("IfCondition(")
    assert "/urdf/one.xacro" in first
    assert "/urdf/two.xacro" not in first
    assert "/urdf/two.xacro" in second.partition("UnlessCondition(")[0]


def test_the_last_description_replaces_those_before_it(folder: Folder) -> None:
    text = launched(folder, param("one"), param("two"), SPAWN.format("robot_description"))
    assert text.count('executable="robot_state_publisher"') == 1
    assert "/urdf/two.xacro" in text
    assert "/urdf/one.xacro" not in text


def test_a_description_that_is_replaced_under_a_condition_is_published_otherwise(folder: Folder) -> None:
    text = launched(folder, param("one"), param("two", IF_REAL[0]))
    before, _, after = text.partition('UnlessCondition(LaunchConfiguration("real"))')
    assert "/urdf/one.xacro" in before
    assert "/urdf/two.xacro" in after
    assert 'IfCondition(LaunchConfiguration("real"))' in after


def test_a_publisher_under_a_condition_has_the_description_of_that_condition(folder: Folder) -> None:
    groups = [IN_GROUPS[0].format(param("one") + PUBLISHER), IN_GROUPS[1].format(param("two"))]
    text = launched(folder, *groups)
    assert text.count('executable="robot_state_publisher"') == 1
    assert "/urdf/one.xacro" in text
    assert "/urdf/two.xacro" not in text


def test_a_text_that_no_publisher_and_no_simulator_reads_is_no_description(folder: Folder) -> None:
    lines = [param("one"), param("two", name="box_description"), SPAWN.format("robot_description")]
    text = launched(folder, *lines)
    assert text.count('executable="robot_state_publisher"') == 1
    assert "give 'box_description' to the node that reads it" in text


def test_a_description_of_another_name_that_the_simulator_reads_is_published(folder: Folder) -> None:
    text = launched(folder, param("one"), param("two", name="box_description"), SPAWN.format("box_description"))
    assert text.count('executable="robot_state_publisher"') == 2
    assert 'remappings=[("robot_description", "box_description")]' in text
    assert '"-topic", "box_description"' in text


MANY = """\
<launch>
  <arg name="pose" default="-x 0 -y 1"/><arg name="x" default="2"/><arg name="more" default=""/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/one.xacro"/>
  <node pkg="gazebo_ros" type="spawn_model" name="s" args="-urdf -model arm -param robot_description {words}"/>
</launch>
"""


@pytest.mark.parametrize(("words", "shell"), [("$(arg pose)", True), ("-x $(arg x)", False), ("$(arg more)", True)])
def test_a_command_line_with_several_words_in_an_argument_is_split_by_a_shell(
    folder: Folder, words: str, shell: bool
) -> None:
    files = {"launch/arm.launch": MANY.format(words=words), "urdf/one.xacro": arm(transmission("EffortJointInterface"))}
    after = migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"]
    assert ("shell=True" in after) is shell


WORLD = """\
<launch>
  <arg name="paused" default="true"/>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"><arg name="paused" value="$(arg paused)"/>
    <env name="GAZEBO_MODEL_PATH" value="$(find arm)/models"/></include>
  {include}
</launch>
"""
SPAWNER = '<launch><node name="c" pkg="controller_manager" type="spawner" args="ctl"/></launch>'


@pytest.mark.parametrize(
    ("include", "paused"), [('<include file="$(find arm)/launch/control.launch"/>', "false"), ("", "true")]
)
def test_a_simulation_whose_controllers_are_started_by_another_file_is_not_paused(
    folder: Folder, include: str, paused: str
) -> None:
    files = {"launch/world.launch": WORLD.format(include=include), "launch/control.launch": SPAWNER}
    text = migrated(folder, files, "--simulator", "gz")["launch/world.launch.py"]
    assert f'DeclareLaunchArgument("paused", default_value="{paused}")' in text
    variable = text.index('SetEnvironmentVariable("GZ_SIM_RESOURCE_PATH", [FindPackageShare("arm"), "/models"])')
    assert text.index("GroupAction(") < variable < text.index("IncludeLaunchDescription(\n")


def test_what_a_parameter_of_the_simulator_ran_is_named(folder: Folder) -> None:
    node = '<node pkg="gazebo_ros" type="spawn_model" name="s" args="-urdf -model a -file /tmp/a.urdf">{}</node>'
    made = '<param name="made" command="rosrun xacro xacro -o /tmp/a.urdf $(find arm)/urdf/one.xacro"/>'
    after = migrated(folder, {"launch/arm.launch": f"<launch>{node.format(made)}</launch>"}, "--simulator", "gz")
    assert (
        "-o /tmp/a.urdf $(find arm)/urdf/one.xacro' was run for parameter 'made': run it before"
        in after["MIGRATION.md"]
    )


def test_descriptions_of_files_that_are_started_together_are_named(folder: Folder) -> None:
    robot = arm(transmission("EffortJointInterface"))
    include = '<include file="$(find arm)/launch/upload.launch"/>'
    files = {
        "launch/upload.launch": f"<launch>{param('one')}</launch>",
        "launch/both.launch": f"<launch>{include}{param('two')}{PUBLISHER}</launch>",
        "launch/one.launch": f"<launch>{include}</launch>",
        "urdf/one.xacro": robot,
        "urdf/two.xacro": robot,
    }
    after = migrated(folder, files, "--simulator", "gz")
    assert "has a robot_state_publisher now: keep one" in after["launch/both.launch.py"]
    assert "has a robot_state_publisher now: keep one" not in after["launch/one.launch.py"]


JOINTS = """\
<launch>
  <arg name="paused" default="false"/>
  <arg name="joints" default="-J knee 0.5 -J hip 1"/>
  <arg name="unpause" value="$(eval '' if arg('paused') else '-unpause')"/>
  <param name="robot_description"
    command="xacro $(find arm)/urdf/one.xacro xyz:='$(arg paused) 1 2' who:='a b' $(arg joints)"/>
  <node pkg="gazebo_ros" type="spawn_model" name="s"
    args="-urdf -model arm -param robot_description $(arg unpause) $(arg joints)"/>
</launch>
"""


def test_options_in_arguments_that_the_spawner_of_gz_refuses_are_left_out(folder: Folder) -> None:
    files = {"launch/arm.launch": JOINTS, "urdf/one.xacro": arm(transmission("EffortJointInterface"))}
    text = " ".join(migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"].split())
    assert 'arguments=["-name", "arm", "-topic", "robot_description"]' in text
    assert "'$(arg joints)' gave the spawner -J, which 'create' does not have" in text
    assert """ xyz:='", LaunchConfiguration("paused"), " 1 2' who:='a b' ", LaunchConfiguration("joints")]""" in text


def test_a_description_that_an_included_file_publishes_is_not_published_again(folder: Folder) -> None:
    include = '<include file="$(find arm)/launch/upload.launch"/>'
    files = {
        "launch/upload.launch": f"<launch>{param('one')}</launch>",
        "launch/both.launch": f"<launch>{include}{param('one')}{SPAWN.format('robot_description')}</launch>",
        "urdf/one.xacro": arm(transmission("EffortJointInterface")),
    }
    after = migrated(folder, files, "--simulator", "gz")
    assert 'package="robot_state_publisher"' in after["launch/upload.launch.py"]
    assert 'package="robot_state_publisher"' not in after["launch/both.launch.py"]
    assert "keep one" not in after["launch/both.launch.py"]


def test_words_between_quotes_are_one_word_of_a_command_line(folder: Folder) -> None:
    node = """<node pkg="arm" type="a" name="a" args="--name 'two words' &quot;$(find arm)/a b&quot;"/>"""
    launch = {"launch/arm.launch": f"<launch>{node}</launch>"}
    text = " ".join(migrated(folder, launch)["launch/arm.launch.py"].split())
    assert 'arguments=["--name", "two words", [FindPackageShare("arm"), "/a b"]]' in text
    in_xml = migrated(folder, launch, "--launch", "xml")["launch/arm.launch.xml"]
    assert """args="--name 'two words' '$(find-pkg-share arm)/a b'\"""" in in_xml


def test_tests_of_rostest_and_programs_without_an_ending_are_listed(folder: Folder) -> None:
    files = {"test/arm.test": "<launch/>", "nodes/mover": "\n#!/usr/bin/env python\nimport rospy\n"}
    report = migrated(folder, files)["MIGRATION.md"]
    assert "`test/arm.test:1`: is a test of rostest" in report
    assert "`nodes/mover:3`: is a node of rospy" in report


def test_scripts_that_run_commands_of_ros_1_are_listed(folder: Folder) -> None:
    scripts = {
        "start.sh": "#!/bin/sh\nsleep 2; roslaunch arm arm.launch\n",
        "go.sh": "#!/bin/sh\n# roslaunch before\nls\n",
    }
    report = migrated(folder, {**scripts, "urdf/one.xacro": arm("")})["MIGRATION.md"]
    assert "`start.sh:2`: runs commands of ROS 1" in report
    assert "go.sh" not in report


def test_a_launch_file_may_have_any_name_that_ends_with_xml(folder: Folder) -> None:
    upload = '<include file="$(find arm)/launch/upload.xml"/>'
    files = {
        "launch/upload.xml": f"<launch>{param('one')}</launch>",
        "launch/arm.launch": f"<launch>{upload}{PUBLISHER}{SPAWN.format('robot_description')}</launch>",
        "config/notes.xml": "<notes/>",
        "urdf/one.xacro": arm(transmission("EffortJointInterface")),
    }
    after = migrated(folder, files, "--simulator", "gz")
    assert 'FindPackageShare("arm"), "/urdf/one.xacro"' in after["launch/upload.launch.py"]
    assert '"/launch/upload.launch.py"' in after["launch/arm.launch.py"]
    assert "launch/upload.xml" not in after
    assert after["config/notes.xml"] == "<notes/>"


@pytest.mark.parametrize(("given", "shell"), [("states ctl", True), ("states", False), ("$(arg both)", True)])
def test_a_shell_splits_the_words_that_another_launch_file_gives(folder: Folder, given: str, shell: bool) -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="$(arg name)"/>'
    include = f'<include file="$(find arm)/launch/one.launch"><arg name="name" value="{given}"/></include>'
    files = {
        "launch/one.launch": f'<launch><arg name="name" default="ctl"/>{spawner}</launch>',
        "launch/all.launch": f'<launch><arg name="both" default="ctl states"/>{include}</launch>',
    }
    assert ("shell=True" in migrated(folder, files)["launch/one.launch.py"]) is shell


def test_two_launch_files_that_differ_in_their_ending_keep_two_names(folder: Folder) -> None:
    include = '<include file="$(find arm)/launch/arm.launch.xml"><arg name="rate" value="5"/></include>'
    node = '<node pkg="arm" type="mover" name="mover"><param name="rate" value="$(arg rate)"/></node>'
    files = {
        "launch/arm.launch": f"<launch>{include}</launch>",
        "launch/arm.launch.xml": f'<launch><arg name="rate"/>{node}</launch>',
    }
    after = migrated(folder, files)
    assert '"/launch/arm_include.launch.py"' in after["launch/arm.launch.py"]
    assert 'executable="mover"' in after["launch/arm_include.launch.py"]


@pytest.mark.parametrize(
    ("spawned", "published", "is_told"),
    [("", 'if="$(arg tf)"', True), ('if="$(arg tf)"', 'if="$(arg tf)"', False), ("", "", False)],
)
def test_a_robot_that_is_spawned_without_its_publisher_is_named(
    folder: Folder, spawned: str, published: str, is_told: bool
) -> None:
    launch = f"""\
<launch>
  <arg name="tf" default="true"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/one.xacro"/>
  <node name="s" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model a" {spawned}/>
  <group {published}><node name="p" pkg="robot_state_publisher" type="robot_state_publisher"/></group>
</launch>
"""
    files = {"launch/arm.launch": launch, "urdf/one.xacro": arm(transmission("EffortJointInterface"))}
    text = migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"]
    assert ("it waits for its description then" in text) is is_told


def test_one_of_two_publishers_is_enough_for_a_robot_that_is_spawned(folder: Folder) -> None:
    publisher = '<node name="{}" pkg="robot_state_publisher" type="robot_state_publisher" {}="$(arg tf)"/>'
    launch = f"""\
<launch>
  <arg name="tf" default="true"/>
  <param name="robot_description" command="$(find xacro)/xacro $(find arm)/urdf/one.xacro"/>
  <node name="s" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model a"/>
  {publisher.format("p", "if")}
  {publisher.format("q", "unless")}
</launch>
"""
    files = {"launch/arm.launch": launch, "urdf/one.xacro": arm(transmission("EffortJointInterface"))}
    text = migrated(folder, files, "--simulator", "gz")["launch/arm.launch.py"]
    assert "it waits for its description then" not in text


@pytest.mark.parametrize("form", ["-sdf", "-urdf"])
@pytest.mark.parametrize(
    ("set_by", "expected"),
    [
        ('textfile="$(find arm)/models/tag.sdf"', '"-file", [FindPackageShare("arm"), "/models/tag.sdf"]'),
        (
            'command="$(find xacro)/xacro $(find arm)/tag.xacro"',
            '"-string", Command(["xacro ", FindPackageShare("arm")',
        ),
    ],
)
def test_a_model_in_a_parameter_that_nobody_publishes_is_spawned_without_a_topic(
    folder: Folder, form: str, set_by: str, expected: str
) -> None:
    tag, put = f'<param name="tag" {set_by}/>', SPAWN.format("tag").replace("-urdf", form)
    text = launched(folder, param("one"), PUBLISHER, SPAWN.format("robot_description"), tag, put)
    assert text.count('"-topic"') == text.count('"-topic", "robot_description"') == 1
    assert expected in text
    assert "TODO" not in text
