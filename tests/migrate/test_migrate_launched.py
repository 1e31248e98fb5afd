"""What migrated launch files start, by running them against a stand-in for launch and launch_ros."""

from __future__ import annotations

from typing import Any

import pytest
from folder import Folder
from ros1_packages import EFFORT, arm, migrated, transmission
from simulated_start import faults
from started import NotStarted, started

ROBOT = arm(
    transmission("hardware_interface/EffortJointInterface"),
    '  <gazebo><plugin name="c" filename="libgazebo_ros_control.so">'
    "<robotNamespace>/arm</robotNamespace></plugin></gazebo>\n",
)
DESCRIPTION = '<param name="robot_description" command="$(find xacro)/xacro $(find arm)/arm.xacro"/>'
WORLD = '<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'
SPAWN = '<node name="put" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>'
PUBLISHER = '<node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher"/>'
LOADED = '<rosparam file="$(find arm)/config/c.yaml"/>'
SPAWNER = '<node name="s" pkg="controller_manager" type="spawner" ns="/arm" args="ctl"/>'
SIMULATED = (WORLD, DESCRIPTION, SPAWN, PUBLISHER, LOADED, SPAWNER)


def launch(*lines: str) -> str:
    return f"<launch>{''.join(lines)}</launch>\n"


def run(folder: Folder, files: dict[str, str], *given: str) -> list[dict[str, Any]]:
    """Migrate a package and return what its a.launch starts then."""
    migrated(folder, {"arm.xacro": ROBOT, "config/c.yaml": EFFORT, **files})
    return started(folder.path / "new" / "launch" / "a.launch.py", folder.path / "new", *given)


def test_a_simulated_robot_is_created_and_controlled(folder: Folder) -> None:
    found = run(folder, {"launch/a.launch": launch(*SIMULATED)})
    assert faults(found) == []
    programs = {one.get("executable") for one in found}
    assert programs >= {"create", "robot_state_publisher", "parameter_bridge", "spawner"}


def test_a_description_that_a_publisher_remaps_is_the_topic_of_all(folder: Folder) -> None:
    remap = '><remap from="robot_description" to="arm_description"/></node>'
    named = [one.replace('="robot_description"', '="arm_description"') for one in SIMULATED]
    lines = [one.replace("-param robot_description", "-param arm_description") for one in named]
    lines[3] = lines[3].replace("/>", remap)
    assert faults(run(folder, {"launch/a.launch": launch(*lines)})) == []


def test_a_manager_reads_one_of_several_published_descriptions(folder: Folder) -> None:
    second = PUBLISHER.replace('"rsp"', '"view" ns="view"')
    assert faults(run(folder, {"launch/a.launch": launch(*SIMULATED, second)})) == []


def test_an_included_file_has_its_own_arguments(folder: Folder) -> None:
    relay = '<node pkg="topic_tools" type="relay" name="{0}" args="{0} $(arg to)"/>'
    files = {
        "launch/a.launch": launch(
            '<arg name="on" default="true"/>',
            '<include file="$(find arm)/launch/one.launch"><arg name="to" value="first"/></include>',
            '<include file="$(find arm)/launch/two.launch"/>',
        ),
        "launch/one.launch": launch(
            '<arg name="to"/><arg name="on" default="false"/>',
            relay.format("x"),
            f'<group if="$(arg on)">{SPAWN}</group>',
        ),
        "launch/two.launch": launch('<arg name="to" default="second"/>', relay.format("y")),
    }
    found = run(folder, files)
    assert [one["words"] for one in found] == [["x", "first"], ["y", "second"]]


def test_a_world_that_is_empty_by_default_is_the_empty_one_of_gz(folder: Folder) -> None:
    given = WORLD.replace("/>", '><arg name="world_name" value="$(arg map)"/></include>')
    lines = ('<arg name="map" default=""/>', given, *SIMULATED[1:])
    assert faults(run(folder, {"launch/a.launch": launch(*lines)})) == []


@pytest.mark.parametrize(
    ("server", "options"),
    [
        ('"gzserver" args="-e ode --verbose $(find arm)/worlds/a.world"', ["-r", "-s", "-v4", "a.world"]),
        ('"gzserver" args="-u"', ["-r", "-s", "empty.sdf"]),  # a paused simulation activates no controller
        ('"gazebo" args="$(find arm)/worlds/a.world"', ["-r", "a.world"]),
    ],
)
def test_a_server_and_its_window_are_one_simulation(folder: Folder, server: str, options: list[str]) -> None:
    program = '<node name="{0}" pkg="gazebo_ros" type={1}/>'
    window = program.format("gui", '"gzclient"') if "gzserver" in server else ""
    lines = (program.format("sim", server), window, *SIMULATED[1:])
    files = {"launch/a.launch": launch(*lines), "worlds/a.world": '<sdf version="1.6"><world name="w"/></sdf>'}
    found = run(folder, files)
    assert faults(found) == []
    given = [one["arguments"]["gz_args"].split() for one in found if one["kind"] == "include"]
    assert [[word.rpartition("/")[2] for word in words] for words in given] == [options, *([["-g"]] if window else [])]
    assert len([one for one in found if one.get("executable") == "parameter_bridge"]) == 1


@pytest.mark.parametrize(
    ("given", "options"),
    [
        ("verbose:=false", ["-r", "-s", "a.world"]),
        ("verbose:=true", ["-r", "-s", "-v4", "a.world"]),
        ("map:=b", ["-r", "-s", "b.world"]),
    ],
)
def test_a_copy_of_the_empty_world_keeps_its_options_and_its_world(
    folder: Folder, given: str, options: list[str]
) -> None:
    """The command line of gazebo_ros' empty_world.launch: each of its options is an argument with a condition."""
    lines = (
        '<arg name="paused" default="false"/><arg name="verbose" default="false"/><arg name="debug" default="false"/>',
        '<arg name="more" default=""/><arg name="map" default="a"/>',
        '<arg name="world_name" value="$(find arm)/worlds/$(arg map).world"/>',
        '<arg unless="$(arg paused)" name="command1" value=""/><arg if="$(arg paused)" name="command1" value="-u"/>',
        '<arg unless="$(arg verbose)" name="command2" value=""/>',
        '<arg if="$(arg verbose)" name="command2" value="--verbose"/>',
        '<arg unless="$(arg debug)" name="script" value="gzserver"/>',
        '<arg if="$(arg debug)" name="script" value="debug"/>',
        '<node name="gazebo" pkg="gazebo_ros" type="$(arg script)"',
        ' args="$(arg command1) $(arg command2) -e ode $(arg more) $(arg world_name)"/>',
        *SIMULATED[1:],
    )
    world = '<sdf version="1.6"><world name="w"/></sdf>'
    files = {"launch/a.launch": launch(*lines), "worlds/a.world": world, "worlds/b.world": world}
    found = run(folder, files, given)
    assert faults(found) == []
    words = [one["arguments"]["gz_args"].split() for one in found if one["kind"] == "include"]
    assert [[word.rpartition("/")[2] for word in one] for one in words] == [options]


def test_a_robot_spawned_from_its_file_is_what_xacro_makes_of_it(folder: Folder) -> None:
    """The migrated robot names its controllers by $(find), which gz does not read."""
    spawn = SPAWN.replace("-param robot_description", "-file $(find arm)/arm.xacro")
    found = run(folder, {"launch/a.launch": launch(*SIMULATED[:2], spawn, *SIMULATED[3:])})
    assert faults(found) == []
    words = next(one["words"] for one in found if one.get("executable") == "create")
    assert words[0] == "-string"
    assert "<parameters>/" in words[1]


def test_a_model_without_controllers_is_spawned_from_its_file(folder: Folder) -> None:
    spawn = SPAWN.replace("-param robot_description", "-file $(find arm)/box.urdf")
    box = '<robot name="box"><link name="box"/></robot>'
    found = run(folder, {"launch/a.launch": launch(*SIMULATED, spawn), "box.urdf": box})
    words = [one["words"] for one in found if one.get("executable") == "create"]
    assert [one[0] for one in words] == ["-topic", "-file"]


def test_a_spawner_gets_the_file_of_its_controllers_and_not_one_whose_name_ends_like_it(folder: Folder) -> None:
    other = EFFORT.replace("ctl", "other").replace("arm:", "arm: # the arm's")
    loaded = [LOADED.replace("c.yaml", name) for name in ("arm_c.yaml", "c.yaml")]
    spawners = [SPAWNER.replace('name="s"', 'name="o"').replace('args="ctl"', 'args="other"'), SPAWNER]
    lines = (*SIMULATED[:4], loaded[0], spawners[0], loaded[1], spawners[1])
    found = run(folder, {"launch/a.launch": launch(*lines), "config/arm_c.yaml": other})
    words = [one["words"] for one in found if one.get("executable") == "spawner"]
    assert [one[-1].rpartition("/")[2] for one in words] == ["arm_c.yaml", "c.yaml"]


def test_two_robots_that_share_a_launch_file_read_the_description_where_it_is_set(folder: Folder) -> None:
    """A robot_state_publisher without a description of its own is started where that is set, not in the shared file."""
    one = f'<launch><arg name="name"/>{SPAWN.replace("-param ", "-param /")}{PUBLISHER}</launch>'
    include = (
        '<group ns="{0}"><include file="$(find arm)/launch/one.launch"><arg name="name" value="{0}"/></include></group>'
    )
    files = {
        "launch/a.launch": launch(WORLD, DESCRIPTION, include.format("left"), LOADED, SPAWNER),
        "launch/b.launch": launch(DESCRIPTION, include.format("right")),
        "launch/one.launch": one,
    }
    found = run(folder, files)
    assert faults(found) == []


def test_a_launch_file_that_spawns_into_a_running_simulator_has_its_time(folder: Folder) -> None:
    found = run(folder, {"launch/a.launch": launch(*SIMULATED[1:]), "launch/sim.launch": launch(WORLD)})
    publisher = next(one for one in found if one.get("executable") == "robot_state_publisher")
    assert publisher["values"]["use_sim_time"] is True


def test_pass_all_args_gives_what_the_included_file_needs(folder: Folder) -> None:
    files = {
        "launch/a.launch": launch(
            '<arg name="gui" default="false"/>',
            '<include file="$(find arm)/launch/sim.launch" pass_all_args="true"/>',
            *SIMULATED[1:],
        ),
        "launch/sim.launch": launch('<arg name="gui"/>', WORLD.replace("/>", ' pass_all_args="true"/>')),
    }
    found = run(folder, files)
    assert faults(found) == []
    gz = next(one for one in found if one["kind"] == "include")
    assert gz["arguments"]["gz_args"].split() == ["-r", "-s", "empty.sdf"]


@pytest.mark.parametrize(("given", "file"), [("soft:=true", "soft.yaml"), ("soft:=false", "c.yaml")])
def test_the_condition_of_a_rosparam_chooses_the_file_of_the_spawner(folder: Folder, given: str, file: str) -> None:
    chosen = LOADED.replace("/>", ' unless="$(arg soft)"/>')
    soft = LOADED.replace("c.yaml", "soft.yaml").replace("/>", ' if="$(arg soft)"/>')
    lines = ('<arg name="soft" default="false"/>', *SIMULATED[:4], chosen, soft, SPAWNER)
    found = run(folder, {"launch/a.launch": launch(*lines), "config/soft.yaml": EFFORT}, given)
    words = next(one["words"] for one in found if one.get("executable") == "spawner")
    assert [word.rpartition("/")[2] for word in words if word.endswith(".yaml")] == [file]


@pytest.mark.parametrize(("given", "file"), [("soft:=true", "soft.yaml"), ("soft:=false", "c.yaml")])
def test_the_condition_of_a_group_chooses_the_file_of_the_spawner(folder: Folder, given: str, file: str) -> None:
    stiff = f'<group unless="$(arg soft)">{LOADED}</group>'
    soft = f'<group if="$(arg soft)">{LOADED.replace("c.yaml", "soft.yaml")}</group>'
    lines = ('<arg name="soft" default="false"/>', *SIMULATED[:4], stiff, soft, SPAWNER)
    found = run(folder, {"launch/a.launch": launch(*lines), "config/soft.yaml": EFFORT}, given)
    assert faults(found) == []
    words = next(one["words"] for one in found if one.get("executable") == "spawner")
    assert [word.rpartition("/")[2] for word in words if word.endswith(".yaml")] == [file]
    assert "no plugin of gz loads" not in (folder.path / "new" / "MIGRATION.md").read_text()


def test_a_file_with_types_that_the_plugin_of_the_simulator_does_not_load_is_told(folder: Folder) -> None:
    other = f'<group if="$(arg soft)">{LOADED.replace("c.yaml", "soft.yaml")}</group>'
    stiff = f'<group unless="$(arg soft)">{LOADED}</group>'
    lines = ('<arg name="soft" default="false"/>', *SIMULATED[:4], stiff, other, SPAWNER)
    soft = f"{EFFORT.replace('JointEffort', 'JointPosition')}    pid: {{p: 1.0}}\n"
    run(folder, {"launch/a.launch": launch(*lines), "config/soft.yaml": soft})
    told = (folder.path / "new" / "MIGRATION.md").read_text()
    said = "no plugin of gz loads '$(find arm)/config/soft.yaml', which declares ctl: name it in <parameters> too"
    assert said in told


@pytest.mark.parametrize(
    ("value", "given", "expected"),
    [("true", [], True), ("$(arg sim)", ["sim:=true"], True), ("$(arg sim)", ["sim:=false"], False)],
)
def test_the_time_that_a_later_parameter_sets_is_that_of_all_nodes(
    folder: Folder, value: str, given: list[str], expected: bool
) -> None:
    time = f'<arg name="sim" default="true"/><param name="use_sim_time" value="{value}"/>'
    found = run(folder, {"launch/a.launch": launch(DESCRIPTION, PUBLISHER, time)}, *given)
    assert [one["values"]["use_sim_time"] for one in found if "values" in one] == [expected]


def test_a_parameter_that_is_a_double_in_ros_2_is_one_whatever_an_argument_says(folder: Folder) -> None:
    rate = '<param name="publish_frequency" value="{}"/></node>'
    files = {
        "launch/a.launch": launch(
            '<arg name="rate" default="40"/>',
            DESCRIPTION,
            PUBLISHER.replace("/>", f">{rate.format('$(arg rate)')}"),
            PUBLISHER.replace('"rsp"/', '"view"/').replace("/>", f">{rate.format(50)}").replace("rsp", "view"),
        )
    }
    rates = [one["values"]["publish_frequency"] for one in run(folder, files)]
    assert rates == [40.0, 50.0]
    assert all(isinstance(one, float) for one in rates)


def test_a_node_and_what_is_in_it_keep_their_own_conditions(folder: Folder) -> None:
    inner = '<param name="a" value="1" if="$(arg a)"/>'
    node = f'<node pkg="twist_mux" type="twist_mux" name="m" if="$(arg on)">{inner}</node>'
    files = {"launch/a.launch": launch('<arg name="on" default="false"/><arg name="a" default="true"/>', node)}
    assert run(folder, files) == []


@pytest.mark.parametrize(
    ("command", "said"),
    [
        ("rosrun xacro xacro $(find arm)/arm.xacro", ""),
        ("cat $(find arm)/arm.xacro", ""),
        (
            "$(find arm)/scripts/wrap.sh $(find xacro)/xacro $(find arm)/arm.xacro",
            "the description went through 'wrap.sh'",
        ),
        ("$(find arm)/scripts/make.py --arm", "port its program to ROS 2"),
    ],
)
def test_the_command_that_prints_a_description_is_xacro_or_is_said(folder: Folder, command: str, said: str) -> None:
    lines = launch(f'<param name="robot_description" command="{command}"/>', PUBLISHER)
    after = migrated(folder, {"arm.xacro": ROBOT, "launch/a.launch": lines})
    assert said in after["MIGRATION.md"]
    if "make.py" not in command:
        found = started(folder.path / "new" / "launch" / "a.launch.py", folder.path / "new")
        assert "<robot" in found[0]["values"]["robot_description"]


def test_a_file_for_a_filter_of_ros_2_has_doubles(folder: Folder) -> None:
    loaded = '<rosparam file="$(find arm)/e.yaml"/>'
    node = f'<node pkg="robot_localization" type="ekf_localization_node" name="e">{loaded}</node>'
    text = "frequency: 30  # Hz\nprocess_noise_covariance: [0.05, 0,  # x\n  1, 0]\nodom0_queue_size: 2\n"
    after = migrated(folder, {"launch/a.launch": launch(node), "e.yaml": text})["e.yaml"]
    assert "frequency: 30.0  # Hz\n" in after
    assert "process_noise_covariance: [0.05, 0.0,  # x\n" in after
    assert "  1.0, 0.0]\n" in after
    assert "odom0_queue_size: 2\n" in after


def test_the_stand_in_raises_where_launch_does(folder: Folder) -> None:
    head = "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
    body = "def generate_launch_description():\n    return LaunchDescription([Node({})])\n"
    for given in ("package='a', executable='b', parameter=[]", "package='a', executable='b', arguments=[1]"):
        folder.write({"a.launch.py": head + body.format(given)})
        with pytest.raises(NotStarted, match="TypeError"):
            started(folder.path / "a.launch.py", folder.path)
