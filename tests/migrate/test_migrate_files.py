"""What a migration between distros changes in descriptions, launch files in XML, and MoveIt's configuration."""

from __future__ import annotations

import re

from folder import Folder
from humble_packages import HUMBLE, controllers, migrated

DIFF = "diff_drive_controller/DiffDriveController"
FINGERS = """\
<robot name="hand">
  <link name="palm"/><link name="left"/><link name="right"/>
  <joint name="finger" type="prismatic">
    <parent link="palm"/><child link="left"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <joint name="other" type="prismatic">
    <parent link="palm"/><child link="right"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/>
  </joint>
  <ros2_control name="hand" type="system">
    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
    <joint name="finger"><command_interface name="position"/><state_interface name="position"/></joint>
    <joint name="other">
      <param name="mimic">finger</param>
      <param name="multiplier">1</param>
      <command_interface name="position"/>
      <state_interface name="position"/>
    </joint>
  </ros2_control>
</robot>
"""


def test_a_mimic_joint_of_ros2_control_becomes_one_of_the_urdf_without_commands(folder: Folder) -> None:
    after = migrated(folder, {"urdf/hand.urdf": FINGERS}, "--to", "jazzy")["urdf/hand.urdf"]
    wanted = re.sub(r' +<param name="(mimic|multiplier)">.*\n', "", FINGERS)
    wanted = wanted.replace(
        '    <joint name="other">\n      <command_interface name="position"/>\n', '    <joint name="other">\n'
    )
    head, limit, tail = wanted.rpartition('    <limit lower="0" upper="1" effort="1" velocity="1"/>\n')
    assert after == f'{head}{limit}    <mimic joint="finger" multiplier="1"/>\n{tail}'


def test_a_mimic_joint_whose_urdf_is_elsewhere_is_left_to_the_user(folder: Folder) -> None:
    part = FINGERS.replace('<joint name="other" type', '<joint name="${x}other" type').replace(
        "<robot", "<robot xmlns:xacro='x'"
    )
    after = migrated(folder, {"urdf/hand.xacro": part}, "--to", "jazzy")["urdf/hand.xacro"]
    assert "<!-- TODO(urdfctl): joint 'other' mimics 'finger'" in after
    assert '<param name="mimic">finger</param>' in after


def test_launch_files_in_xml_get_the_topic_and_the_file_of_the_spawner(folder: Folder) -> None:
    launch = """\
<launch>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share arm)/config/controllers.yaml"/>
    <remap from="~/robot_description" to="/robot_description"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="ctl --stopped"/>
</launch>
"""
    files = {"launch/a.launch.xml": launch, "config/controllers.yaml": controllers(DIFF, "odom_frame_id: odom\n")}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.xml"]
    wanted = re.sub(" +<remap.*\n", "", launch)
    file = "$(find-pkg-share arm)/config/controllers.yaml"
    assert after == wanted.replace("ctl --stopped", f"ctl --inactive --param-file {file}")


def test_a_spawner_in_xml_gets_the_file_that_an_argument_chooses_for_the_manager(folder: Folder) -> None:
    file = "$(find-pkg-share arm)/config/$(var file).yaml"
    launch = f"""\
<launch>
  <arg name="file" default="one"/>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="{file}"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="ctl"/>
</launch>
"""
    own = controllers(DIFF, "odom_frame_id: odom\n")
    files = {"launch/a.launch.xml": launch, "config/one.yaml": own, "config/two.yaml": own}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.xml"]
    assert after == launch.replace('args="ctl"', f'args="ctl --param-file {file}"')


TWO_SPAWNERS = """\
from launch_ros.actions import Node

one = Node(package="controller_manager", executable="spawner", arguments=["arm"])
two = Node(package="controller_manager", executable="spawner", arguments=["hand"])
"""


def test_the_file_of_another_spawner_says_nothing_about_a_controller_of_several_files(folder: Folder) -> None:
    arm = controllers(DIFF, "odom_frame_id: odom\n").replace("ctl", "arm")
    hand = controllers(DIFF, "odom_frame_id: hand\n").replace("ctl", "hand")
    both = arm.replace("odom\n", "map\n") + hand.replace("controller_manager", "/hand/controller_manager")
    files = {"launch/a.launch.py": TWO_SPAWNERS, "config/arm.yaml": arm, "config/both.yaml": both}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.py"]
    assert after.count('"--param-file"') == after.count("both.yaml") == 1
    assert re.search(r'# TODO\(urdfctl\): spawn controllers .*\none = .*arguments=\["arm"\]\)', after)


def test_files_with_the_same_parameters_for_a_controller_are_equally_good_for_its_spawner(folder: Folder) -> None:
    own = controllers(DIFF, "odom_frame_id: odom  # fixed\n")
    more = own.replace("  # fixed", "") + "other:\n  ros__parameters: {a: 1}\n"
    launch = TWO_SPAWNERS.replace('"arm"', '"ctl"').partition("two")[0]
    files = {"launch/a.launch.py": launch, "config/one.yaml": own, "config/two.yaml": more}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.py"]
    assert '"config", "one.yaml"' in after
    assert "TODO" not in after


def test_a_spawner_of_a_controller_without_parameters_too_gets_the_file(folder: Folder) -> None:
    own = controllers(DIFF, "odom_frame_id: odom\n")
    launch = TWO_SPAWNERS.replace('"arm"', '"states", "ctl"').partition("two")[0]
    in_xml = '<launch>\n  <node pkg="controller_manager" exec="spawner" args="states ctl"/>\n</launch>\n'
    files = {"launch/a.launch.py": launch, "launch/b.launch.xml": in_xml, "config/c.yaml": own}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")
    assert '"states", "ctl", "--param-file"' in " ".join(after["launch/a.launch.py"].split())
    assert 'args="states ctl --param-file $(find-pkg-share arm)/config/c.yaml"' in after["launch/b.launch.xml"]


def test_a_spawner_in_xml_whose_file_is_not_known_is_left_to_a_person(folder: Folder) -> None:
    in_xml = '<launch>\n  <node pkg="controller_manager" exec="spawner" args="ctl"/>\n</launch>\n'
    one, two = (controllers(DIFF, f"odom_frame_id: {frame}\n") for frame in ("odom", "map"))
    files = {"launch/b.launch.xml": in_xml, "config/c.yaml": one, "config/d.yaml": two}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/b.launch.xml"]
    assert re.search(r"<!-- TODO\(urdfctl\): spawn controllers .* -->\n  <node ", after)


def test_a_spawner_whose_line_would_be_too_long_gets_a_line_for_each_argument(folder: Folder) -> None:
    head = "from launch_ros.actions import Node\n\n"
    node = "Node(\n    package='controller_manager', executable='spawner',\n    arguments=['ctl', '-c', '/cm'],\n)\n"
    launch = f"{head}{node}"
    files = {"launch/a.launch.py": launch, "config/c.yaml": controllers(DIFF, "odom_frame_id: odom\n")}
    after = migrated(folder, files, "--to", "jazzy", "--only", "launch")["launch/a.launch.py"]
    file = 'PathJoinSubstitution([FindPackageShare("arm"), "config", "c.yaml"])'
    items = "".join(f"\n        {item}," for item in ("'ctl'", "'-c'", "'/cm'", "'--param-file'", file))
    assert f"    arguments=[{items}\n    ],\n" in after


def test_topics_of_controllers_are_remapped_where_they_are_spawned_from_lyrical_on(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch_ros.actions import Node

LaunchDescription([
    Node(
        package="controller_manager",
        executable="ros2_control_node",
        remappings=[("/ctl/cmd_vel", "/cmd_vel"), ("/gone/x", "/x")],
    ),
    Node(
        package="controller_manager",
        executable="spawner",
        arguments=["ctl"],
    ),
])
"""
    name = "launch/a.launch.py"
    after = migrated(folder, {name: launch}, "--to", "lyrical")[name]
    assert 'arguments=["ctl", "--controller-ros-args", "-r /ctl/cmd_vel:=/cmd_vel"]' in after
    assert 'remappings=[("/gone/x", "/x")]' in after
    assert "# TODO(urdfctl): remap '/gone/x' by --controller-ros-args of the spawner of 'gone'" in after
    assert migrated(folder, {name: launch}, "--to", "kilted")[name] == launch


def test_remappings_and_files_of_spawners_stand_in_the_same_order_over_jazzy_and_at_once(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch_ros.actions import Node

LaunchDescription([
    Node(
        package="controller_manager",
        executable="ros2_control_node",
        parameters=["c.yaml"],
        remappings=[
            ("~/robot_description", "/robot_description"),
            ("/ctl/cmd_vel", "/cmd_vel"),
        ],
    ),
    Node(package="controller_manager", executable="spawner", arguments=["ctl"]),
])
"""
    name = "launch/a.launch.py"
    files = {name: launch, "config/c.yaml": controllers(DIFF, "odom_frame_id: odom\n")}
    at_once = migrated(folder, files, *HUMBLE, "--to", "lyrical", "--only", "launch")
    shown = " ".join(at_once[name].split())
    assert '"ctl", "--param-file", "c.yaml", "--controller-ros-args", "-r /ctl/cmd_vel:=/cmd_vel"' in shown
    assert "remappings=" not in at_once[name]
    over_jazzy = migrated(folder, files, *HUMBLE, "--to", "jazzy", "--only", "launch")
    assert migrated(folder, over_jazzy, "--to", "lyrical", "--only", "launch")[name] == at_once[name]


def test_the_environment_of_hooks_is_renamed(folder: Folder) -> None:
    hook = "prepend-non-duplicate;IGN_GAZEBO_RESOURCE_PATH;share\n# IGN_GAZEBO_RESOURCE_PATH\n"
    after = migrated(folder, {"hooks/arm.dsv.in": hook}, "--to", "jazzy")["hooks/arm.dsv.in"]
    assert after == hook.replace("IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH", 1)


def test_planning_pipelines_get_lists_of_the_adapters_of_jazzy(folder: Folder) -> None:
    text = """\
planning_plugin: ompl_interface/OMPLPlanner
request_adapters: >-
  default_planner_request_adapters/AddTimeOptimalParameterization
  default_planner_request_adapters/FixStartStateBounds
  own/Adapter
range: 0.1  # keep
"""
    name = "config/ompl_planning.yaml"
    after = migrated(folder, {name: text}, "--to", "jazzy", "--only", "moveit")[name]
    assert (
        after
        == """\
planning_plugins:
  - ompl_interface/OMPLPlanner
request_adapters:
  - default_planning_request_adapters/CheckStartStateBounds
  - own/Adapter
response_adapters:
  - default_planning_response_adapters/AddTimeOptimalParameterization
  - default_planning_response_adapters/ValidateSolution
  - default_planning_response_adapters/DisplayMotionPath
range: 0.1  # keep
"""
    )
    assert migrated(folder, {name: after}, "--to", "lyrical")[name] == after


def test_planning_pipelines_in_launch_files_change_in_the_same_way(folder: Folder) -> None:
    launch = """\
pipeline = {
    'planning_plugin': 'p/P',
    'request_adapters': (
        'default_planner_request_adapters/FixWorkspaceBounds '
        'default_planner_request_adapters/FixStartStatePathConstraints'
    ),
}
"""
    name = "launch/a.launch.py"
    after = migrated(folder, {name: launch}, "--to", "jazzy", "--only", "moveit")[name]
    scope: dict[str, dict[str, list[str]]] = {}
    exec(after, scope)  # noqa: S102 (the text is above)
    assert scope["pipeline"] == {
        "planning_plugins": ["p/P"],
        "request_adapters": ["default_planning_request_adapters/ValidateWorkspaceBounds"],
        "response_adapters": [
            "default_planning_response_adapters/ValidateSolution",
            "default_planning_response_adapters/DisplayMotionPath",
        ],
    }


def test_moveit_commands_a_parallel_gripper_by_its_action(folder: Folder) -> None:
    moveit = """\
moveit_simple_controller_manager:
  controller_names: [ctl]
  ctl:
    type: GripperCommand
    action_ns: gripper_cmd
    joints: [finger]
"""
    files = {
        "config/moveit_controllers.yaml": moveit,
        "config/c.yaml": controllers("position_controllers/GripperActionController", "joint: finger\n"),
    }
    after = migrated(folder, files, "--to", "kilted")
    assert "type: parallel_gripper_action_controller/GripperActionController" in after["config/c.yaml"]
    assert after["config/moveit_controllers.yaml"] == moveit.replace("GripperCommand", "ParallelGripperCommand")
    assert migrated(folder, files, "--to", "jazzy") == files


def test_package_xml_depends_on_the_package_of_the_new_type(folder: Folder) -> None:
    manifest = """\
<package format="3">
  <name>arm</name>
  <exec_depend>position_controllers</exec_depend>
</package>
"""
    file = controllers("position_controllers/JointGroupPositionController", "joints: [a]\n")
    after = migrated(folder, {"config/c.yaml": file, "package.xml": manifest}, "--to", "lyrical")
    assert after["package.xml"] == manifest.replace("position_controllers", "forward_command_controller")
