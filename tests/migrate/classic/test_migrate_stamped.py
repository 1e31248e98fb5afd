"""What a migration to jazzy makes of the nodes that command a mobile base, whose controllers read a stamp there."""

from __future__ import annotations

import pytest
from classic_packages import base, migrated
from folder import Folder

DRIVE = """\
controller_manager:
  ros__parameters:
    update_rate: 100
    wheels:
      type: diff_drive_controller/DiffDriveController
wheels:
  ros__parameters:
    left_wheel_names: [left]
    right_wheel_names: [right]
    wheel_separation: 0.4
    wheel_radius: 0.1
"""
ARM = DRIVE.partition("wheels:")[0]


def after(folder: Folder, files: dict[str, str], controllers: str = DRIVE) -> dict[str, str]:
    """The files of a package after its migration."""
    return migrated(folder, {"urdf/base.xacro": base(""), "config/controllers.yaml": controllers, **files})


@pytest.mark.parametrize(
    ("node", "given", "added"),
    [
        ("controller_server", "controller_frequency: 20.0", "enable_stamped_cmd_vel: true"),
        ("twist_mux", "topics: {}", "use_stamped: true"),
        ("my_joystick", "axis_linear:\n      x: 1", "publish_stamped_twist: true"),
    ],
)
def test_a_node_that_commands_the_base_publishes_a_stamp(folder: Folder, node: str, given: str, added: str) -> None:
    text = f"{node}:\n  ros__parameters:\n    {given}\n"
    assert after(folder, {"config/nodes.yaml": text})["config/nodes.yaml"] == f"{text}    {added}\n"


@pytest.mark.parametrize(
    ("text", "controllers"),
    [
        ("controller_server:\n  ros__parameters:\n    enable_stamped_cmd_vel: false\n", DRIVE),
        ("controller_server:\n  ros__parameters:\n    controller_frequency: 20.0\n", ARM),
        ("planner_server:\n  ros__parameters:\n    frequency: 20.0\n", DRIVE),
    ],
)
def test_other_nodes_and_explicit_choices_stay(folder: Folder, text: str, controllers: str) -> None:
    assert after(folder, {"config/nodes.yaml": text}, controllers)["config/nodes.yaml"] == text


def test_the_topic_of_a_drive_loses_its_ending_but_not_that_of_others(folder: Folder) -> None:
    launch = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    topics = [("cmd_vel", "/wheels/cmd_vel_unstamped"), ("out", "/other/cmd_vel_unstamped")]
    return LaunchDescription([Node(package="topic_tools", executable="relay", remappings=topics)])
"""
    shown = after(folder, {"launch/mux.launch.py": launch})["launch/mux.launch.py"]
    assert shown == launch.replace("/wheels/cmd_vel_unstamped", "/wheels/cmd_vel")


MUX = "package='twist_mux', executable='twist_mux'"


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        (f"Node({MUX})", f'Node({MUX}, parameters=[{{"use_stamped": True}}])'),
        (f"Node({MUX}, parameters=[file])", f'Node({MUX}, parameters=[file, {{"use_stamped": True}}])'),
        (f"Node({MUX}, parameters=[{{'use_stamped': False}}])", None),
        ("Node(package='twist_mux', executable='twist_marker')", None),
    ],
)
def test_a_node_that_only_a_launch_file_configures_publishes_a_stamp(
    folder: Folder, node: str, expected: str | None
) -> None:
    text = f"from launch_ros.actions import Node\n\nfile = ''\nmux = {node}\n"
    now = after(folder, {"launch/a.launch.py": text})["launch/a.launch.py"]
    assert now == text.replace(node, expected or node)


def test_a_node_in_xml_publishes_a_stamp_unless_its_file_says_so(folder: Folder) -> None:
    node = '  <node pkg="twist_mux" exec="twist_mux">\n    <param from="/mux.yaml"/>\n  </node>\n'
    text = f"<launch>\n{node}</launch>\n"
    added = node.replace("  </node>", '    <param name="use_stamped" value="true"/>\n  </node>')
    assert after(folder, {"launch/a.launch.xml": text})["launch/a.launch.xml"] == text.replace(node, added)
    alone = '<launch>\n  <node pkg="twist_mux" exec="twist_mux"/>\n</launch>\n'
    opened = alone.replace("/>", '>\n    <param name="use_stamped" value="true"/>\n  </node>')
    assert after(folder, {"launch/a.launch.xml": alone})["launch/a.launch.xml"] == opened
    file = {"config/mux.yaml": "twist_mux:\n  ros__parameters:\n    topics: {}\n"}
    assert after(folder, {"launch/a.launch.xml": text, **file})["launch/a.launch.xml"] == text
