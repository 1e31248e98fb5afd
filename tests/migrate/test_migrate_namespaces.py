"""Namespaces of ROS 1 that must be joined in ROS 2: descriptions, names of controllers, and files of other nodes."""

from __future__ import annotations

import pytest
from folder import Folder
from ros1_packages import arm, migrated, transmission

PLUGIN = """\
  <gazebo><plugin name="control" filename="libgazebo_ros_control.so">
    <robotNamespace>{space}</robotNamespace>
  </plugin></gazebo>
"""
PUBLISHER = '<node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher">{more}</node>'
DESCRIPTION = '<param name="robot_description" command="xacro $(find arm)/arm.urdf.xacro"/>'
SPAWN = '<node name="put" pkg="gazebo_ros" type="spawn_model" args="-urdf -param robot_description -model arm"/>'
TWO_SIDES = """\
left:
  grip: {type: effort_controllers/JointEffortController, joint: shoulder}
right:
  grip: {type: effort_controllers/JointEffortController, joint: shoulder}
states:
  type: joint_state_controller/JointStateController
"""
OTHER_NODES = """\
# the filter
nav:
  filter:
    frequency: 20  # Hz
    odom0_config: [true, false]
lamp: {brightness: 3}
unread: {a: 1}
grip: {type: effort_controllers/JointEffortController, joint: shoulder}
"""


def robot(space: str) -> str:
    return arm(transmission("hardware_interface/EffortJointInterface"), PLUGIN.format(space=space))


def launch(*lines: str) -> str:
    return f"<launch>{''.join(lines)}</launch>\n"


def test_the_manager_reads_the_description_where_another_launch_file_publishes_it(folder: Folder) -> None:
    files = {
        "arm.urdf.xacro": robot("/left_arm"),
        "launch/top.launch": launch(
            '<group ns="cell"><include file="$(find arm)/launch/robot.launch"/></group>',
            SPAWN.replace(" -param ", " -param /cell/"),
        ),
        "launch/robot.launch": launch(DESCRIPTION, PUBLISHER.format(more="")),
    }
    after = migrated(folder, files, "--simulator", "gz")
    assert "<remapping>robot_description:=/cell/robot_description</remapping>" in after["arm.urdf.xacro"]
    assert '"-topic", "/cell/robot_description"' in " ".join(after["launch/top.launch.py"].split())


def test_a_manager_in_the_namespace_of_the_publisher_needs_no_remapping(folder: Folder) -> None:
    inside = f'<group ns="left_arm">{DESCRIPTION}{PUBLISHER.format(more="")}</group>'
    files = {"arm.urdf.xacro": robot("left_arm"), "launch/robot.launch": launch(inside, SPAWN)}
    after = migrated(folder, files, "--simulator", "gz")
    assert "<remapping>" not in after["arm.urdf.xacro"]
    assert '"-topic", "/left_arm/robot_description"' in " ".join(after["launch/robot.launch.py"].split())


def test_a_publisher_without_a_description_keeps_its_remappings_where_it_is_started(folder: Folder) -> None:
    remap = '<remap from="joint_states" to="/left_arm/joint_states"/><param name="tf_prefix" value="left"/>'
    files = {
        "arm.urdf.xacro": robot("/left_arm"),
        "launch/world.launch": launch(DESCRIPTION, SPAWN),
        "launch/control.launch": launch(PUBLISHER.format(more=remap)),
    }
    after = migrated(folder, files, "--simulator", "gz")
    text = " ".join(after["launch/world.launch.py"].split())
    assert 'remappings=[("joint_states", "/left_arm/joint_states")]' in text
    assert '"frame_prefix": "left/"' in text
    assert "robot_state_publisher" not in after["launch/control.launch.py"]


def test_controllers_of_one_name_in_two_namespaces_get_two_names(folder: Folder) -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="left/grip --timeout 9 /right/grip states"/>'
    load = '<rosparam command="load" file="$(find arm)/config/c.yaml"/>'
    files = {"arm.urdf.xacro": robot("/"), "config/c.yaml": TWO_SIDES, "launch/c.launch": launch(load, spawner)}
    after = migrated(folder, files, "--simulator", "gz")
    assert "\nleft_grip:\n" in after["config/c.yaml"]
    assert "\nright_grip:\n" in after["config/c.yaml"]
    assert after["config/c.yaml"].count("controller_manager:") == 1
    assert '"left_grip"' in after["launch/c.launch.py"]
    assert '"right_grip"' in after["launch/c.launch.py"]
    assert "controller 'left/grip' became 'left_grip': its topics are in /left_grip now" in after["MIGRATION.md"]


def test_the_sections_of_nodes_in_a_controller_file_are_given_to_these(folder: Folder) -> None:
    nodes = '<node name="filter" ns="nav" pkg="robot_localization" type="ukf_localization_node"/>'
    nodes += '<node name="lamp" pkg="arm" type="lamp"/>'
    load = '<rosparam command="load" file="$(find arm)/config/c.yaml"/>'
    files = {"arm.urdf.xacro": robot("/"), "config/c.yaml": OTHER_NODES, "launch/c.launch": launch(load, nodes)}
    after = migrated(folder, files, "--simulator", "gz")
    text = after["config/c.yaml"]
    assert "# the filter\n/nav/filter:\n  ros__parameters:\n    frequency: 20.0  # Hz\n" in text
    assert "lamp:\n  ros__parameters: {brightness: 3}\n" in text
    assert "# unread: {a: 1}" in text
    given = 'parameters=[ParameterFile([FindPackageShare("arm"), "/config/c.yaml"])]'
    assert " ".join(after["launch/c.launch.py"].split()).count(given) == 2


def test_a_manager_in_the_root_reads_a_description_in_a_namespace(folder: Folder) -> None:
    inside = f'<group ns="cell">{DESCRIPTION}{PUBLISHER.format(more="")}</group>'
    bare = arm(
        transmission("EffortJointInterface"),
        '  <gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>\n',
    )
    after = migrated(folder, {"arm.urdf.xacro": bare, "launch/r.launch": launch(inside)}, "--simulator", "gz")
    assert "<ros> <remapping>robot_description:=/cell/robot_description</remapping> </ros>" in " ".join(
        after["arm.urdf.xacro"].split()
    )


def test_the_manager_of_spawners_in_a_group_is_in_its_namespace_and_reads_the_description(folder: Folder) -> None:
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="grip"/>'
    load = '<rosparam file="$(find arm)/config/c.yaml"/>'
    files = {
        "arm.urdf.xacro": arm(transmission("hardware_interface/EffortJointInterface")),
        "config/c.yaml": "left:\n  grip: {type: effort_controllers/JointEffortController, joint: shoulder}\n",
        "launch/outside.launch": launch(
            DESCRIPTION, PUBLISHER.format(more=""), load, f'<group ns="left">{spawner}</group>'
        ),
        "launch/inside.launch": launch(f'<group ns="left">{load}{spawner}</group>'),
    }
    after = migrated(folder, files, "--simulator", "none")
    outside, inside = (" ".join(after[f"launch/{name}side.launch.py"].split()) for name in ("out", "in"))
    assert 'executable="ros2_control_node", namespace="/left",' in outside
    assert 'executable="ros2_control_node", parameters=' in inside
    for text in (outside, inside):
        assert 'remappings=[("robot_description", "/robot_description")]' in text


def test_a_spawner_reads_the_description_of_the_launch_files_that_are_started_with_it(folder: Folder) -> None:
    inside = PUBLISHER.format(more="").replace("<node ", '<node ns="/left" ')
    files = {
        "arm.urdf.xacro": robot("/left"),
        "launch/left.launch": launch(DESCRIPTION, SPAWN, inside),
        "launch/put.launch": launch('<include file="$(find arm)/launch/tell.launch"/>', SPAWN),
        "launch/tell.launch": launch(DESCRIPTION, inside),
        "launch/other.launch": launch(DESCRIPTION, SPAWN, PUBLISHER.format(more="")),
    }
    after = migrated(folder, files, "--simulator", "gz")
    topics = {"left": "/left/robot_description", "put": "/left/robot_description", "other": "robot_description"}
    for name, topic in topics.items():
        assert f'"-topic", "{topic}"' in " ".join(after[f"launch/{name}.launch.py"].split())


def test_each_robot_has_the_publisher_of_the_launch_files_that_are_started_with_it(folder: Folder) -> None:
    files = {"arm.urdf.xacro": robot("/left")}
    for side in ("left", "right"):
        remap = f'<remap from="joint_states" to="/{side}/joint_states"/>'
        include = f'<include file="$(find arm)/launch/{side}_control.launch"/>'
        files[f"launch/{side}.launch"] = launch(DESCRIPTION, SPAWN, include)
        files[f"launch/{side}_control.launch"] = launch(PUBLISHER.format(more=remap))
    after = migrated(folder, files, "--simulator", "gz")
    for side in ("left", "right"):
        assert f'remappings=[("joint_states", "/{side}/joint_states")]' in after[f"launch/{side}.launch.py"]


def test_a_new_controller_file_is_for_the_plugins_of_all_namespaces(folder: Folder) -> None:
    robot = arm(transmission("EffortJointInterface"), PLUGIN.format(space="/arm"))
    alone = migrated(folder, {"urdf/one.xacro": robot}, "--simulator", "gz")["config/ros2_controllers.yaml"]
    assert alone.startswith("/arm/controller_manager:\n")
    other = robot.replace("<robotNamespace>/arm</robotNamespace>", "")
    files = {"urdf/one.xacro": robot, "urdf/other.xacro": other}
    after = migrated(folder, files, "--simulator", "gz")["config/ros2_controllers.yaml"]
    assert after.startswith('"/**/controller_manager":\n')


def test_a_description_in_a_namespace_without_a_publisher_is_spawned_there(folder: Folder) -> None:
    described = f"{DESCRIPTION}{SPAWN}"
    files = {
        "arm.urdf.xacro": arm(transmission("EffortJointInterface")),
        "launch/shown.launch": f"<launch>{DESCRIPTION}{PUBLISHER.format(more='')}</launch>",
        "launch/moved.launch": f'<launch><group ns="mobile">{described}</group></launch>',
    }
    text = migrated(folder, files, "--simulator", "gz")["launch/moved.launch.py"]
    assert 'PushRosNamespace("mobile")' in text
    assert 'arguments=["-topic", "robot_description", "-name", "arm"]' in text


def test_the_manager_of_one_of_several_robots_reads_the_description_that_is_started_with_it(folder: Folder) -> None:
    described = DESCRIPTION.replace("arm.urdf", "{}.urdf")
    named = '<xacro:arg name="side" default="left"/>\n'
    files = {
        "arm.urdf.xacro": robot("/$(arg side)").replace('<link name="base"/>', f'{named}<link name="base"/>'),
        "ball.urdf.xacro": '<robot name="ball"><link name="ball"/></robot>\n',
        "launch/arm.launch": launch(described.format("arm"), SPAWN),
        "launch/ball.launch": launch(f'<group ns="ball">{described.format("ball")}{SPAWN}</group>'),
    }
    after = migrated(folder, files, "--simulator", "gz")
    assert "<remapping>robot_description:=/robot_description</remapping>" in after["arm.urdf.xacro"]
    inside = launch(f'<arg name="side"/><group ns="$(arg side)">{described.format("arm")}{SPAWN}</group>')
    (folder.path / "new").rename(folder.path / "first")
    after = migrated(folder, {**files, "launch/arm.launch": inside}, "--simulator", "gz")
    assert "<remapping>" not in after["arm.urdf.xacro"]


GRIP = "grip: {type: effort_controllers/JointEffortController, joint: shoulder}\n"
LOADED = '<rosparam command="load" file="$(find arm)/config/grip.yaml" ns="left"/>'


@pytest.mark.parametrize(
    ("spawner", "manager"),
    [
        ('args="left/grip"', 'executable="ros2_control_node", parameters='),
        ('args="grip" ns="left"', 'executable="ros2_control_node", namespace="left",'),
        ('args="--namespace=/left grip"', 'executable="ros2_control_node", namespace="/left",'),
    ],
)
def test_the_manager_is_where_the_spawner_of_its_controllers_looks_for_it(
    folder: Folder, spawner: str, manager: str
) -> None:
    node = f'<node name="s" pkg="controller_manager" type="spawner" {spawner}/>'
    files = {"arm.urdf.xacro": arm(transmission("hardware_interface/EffortJointInterface")), "config/grip.yaml": GRIP}
    after = migrated(folder, files | {"launch/arm.launch": launch(DESCRIPTION, LOADED, node)}, "--simulator", "none")
    assert manager in " ".join(after["launch/arm.launch.py"].split())


@pytest.mark.parametrize(("included", "starts"), [("base_description", False), ("hokuyo_description", True)])
def test_a_simulated_robot_of_which_a_part_is_elsewhere_gets_no_manager_beside_that_of_the_simulator(
    folder: Folder, included: str, starts: bool
) -> None:
    """The plugin may be in the part that is not here, unless that is a sensor."""
    part = f'<xacro:include filename="$(find {included})/urdf/part.xacro"/>\n'
    own = arm(transmission("hardware_interface/EffortJointInterface"), part)
    spawner = '<node name="s" pkg="controller_manager" type="spawner" args="grip"/>'
    lines = (DESCRIPTION, LOADED.replace(' ns="left"', ""), spawner, SPAWN, PUBLISHER.format(more=""))
    files = {"arm.urdf.xacro": own, "config/grip.yaml": GRIP, "launch/arm.launch": launch(*lines)}
    after = migrated(folder, files, "--simulator", "gz")
    assert ("ros2_control_node" in after["launch/arm.launch.py"]) == starts
    assert ("let the plugin of gz in it load" in after["MIGRATION.md"]) != starts
