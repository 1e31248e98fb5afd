"""What a migration changes beside its files: code that is left to a person, and topics with another name or type."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence

from urdfctl.catalog.distros import ROS2, since
from urdfctl.migrate.distro.names import OWN
from urdfctl.migrate.moved_topics import CODE, beginning, moved_topics
from urdfctl.migrate.options import MigrationOptions
from urdfctl.migrate.report import ReportLine
from urdfctl.migrate.step import EntryKind
from urdfctl.migrate.trial.scratch import Scratch
from urdfctl.output.change import Change
from urdfctl.startup.records import NamedTuple

_BUILD_FILE = "CMakeLists.txt"
_TIMED = r"\b(?:update|read|write)\s*\(\s*const\s+rclcpp::Time\b"
_UNTIMED = rf"(?ms)\A(?!.*{_TIMED}).*?^(?![ \t]*(?://|/?\*))[^\n]*?\breturn_type\s+(?:\w+::)*"
"""The head of a method of ros2_control, in a file whose methods do not get the time."""


class _Code(NamedTuple):
    """Code that a target does not have.

    pattern: what shows it. message: what a person must do. distros: the targets that it is lost in.
    endings: of the files.
    """

    pattern: str
    message: str
    authority: str
    distros: tuple[str, ...] = ROS2
    endings: tuple[str, ...] = CODE


_LOST = (
    _Code(
        r"(?m)^\s*(?:import|from)\s+rospy\b",
        "is a node of rospy, which was not migrated: port it to rclpy",
        "docs.ros.org, Migrating Python packages from ROS 1 to ROS 2",
        endings=("", ".py"),
    ),
    _Code(
        r"#\s*include\s*[<\"](?:ros/ros\.h|nodelet/nodelet\.h)[>\"]",
        "is a node of roscpp, which was not migrated: port it to rclcpp",
        "docs.ros.org, Migrating C++ packages from ROS 1 to ROS 2",
    ),
    _Code(
        r"#\s*include\s*[<\"](?:hardware_interface/robot_hw\.h|gazebo_ros_control/robot_hw_sim\.h)[>\"]",
        "is hardware for ros_control, which was not migrated: write a hardware component of ros2_control",
        "control.ros.org, Writing a Hardware Component",
    ),
    _Code(
        r"#\s*include\s*[<\"]controller_interface/(?:multi_interface_)?controller\.h[>\"]",
        "is a controller for ros_control, which was not migrated: write it for ros2_control",
        "control.ros.org, Writing a new controller",
    ),
    _Code(
        r"\bgazebo_msgs\b",
        "uses gazebo_msgs, which only Gazebo Classic serves: gz has the services of ros_gz_interfaces",
        "ros_gz README: ros_gz_interfaces",
        since("jazzy"),
        endings=("", *CODE),
    ),
    _Code(
        r"#\s*include\s*[<\"]gazebo/(?:gazebo|common|physics|sensors)[^>\"]*[>\"]",
        "is a plugin for Gazebo Classic, which was not migrated: write a system of gz",
        "gazebosim.org, Migration from Gazebo Classic: plugins",
        since("jazzy"),
    ),
    _Code(
        _UNTIMED + r"update\s*\(\s*\)",
        "overrides update() of a controller, which is gone: override update(time, period), and on_init() for init()",
        "ros2_control#520, in galactic: controllers get the time and the period",
        since("humble"),
    ),
    _Code(
        _UNTIMED + r"(?:read|write)\s*\(\s*\)",
        "overrides read() or write() of hardware, which are gone: override them with the time and the period",
        "ros2_control#715, in humble: hardware gets the time and the period",
        since("humble"),
    ),
    _Code(
        r"\bon_init\s*\(\s*const\s+(?:hardware_interface::)?HardwareInfo\b",
        "overrides on_init(const HardwareInfo &), which is gone: override it with HardwareComponentInterfaceParams",
        "ros2_control hardware_component_interface.hpp: deprecated in jazzy and kilted",
        since("lyrical"),
    ),
    _Code(
        r"(?<![\w.])dynamic_joint_states\b",
        "names /dynamic_joint_states, which joint_state_broadcaster does not publish any more: use "
        "state_interfaces_broadcaster or gpio_controllers",
        "ros2_controllers#2107: publish_dynamic_joint_states",
        since("lyrical"),
        endings=("", *CODE),
    ),
    _Code(
        r"(?s)\A(?!.*generate_launch_description).*?/(?:cmd_vel|reference)_unstamped\b",
        "publishes Twist on a topic that is gone: publish TwistStamped on the topic without '_unstamped'",
        "ros2_controllers#812, #958: ~/cmd_vel is always geometry_msgs/msg/TwistStamped",
        since("jazzy"),
        endings=("", *CODE),
    ),
    _Code(
        r"(?m)\bgoal_time:\s*0(?:\.0*)?\s*$",
        "has goal_time: 0.0, which leaves no time now: a negative value waits as 0.0 did",
        "ros2_controllers#2592: goal_time below 0 waits",
        ("rolling",),
        endings=(".yaml", ".yml"),
    ),
    _Code(
        r"(?s)(?=.*command_interfaces:\s*(?:\[\s*velocity\s*\]|\n\s*-\s*velocity\s*\n(?!\s*-)))"
        r"(?=.*interpolate_from_desired_state:\s*true)(?=.*\b[pid]:\s*[0-9.]*[1-9])",
        "has gains for a velocity interface that ran open loop: its PID runs now; with gains of zero it stays so",
        "ros2_controllers joint_trajectory_controller.cpp: use_closed_loop_pid_adapter_; #1525",
        since("kilted"),
        endings=(".yaml", ".yml"),
    ),
    _Code(
        r"(?m)^[^#\n]*?(?<![\w./-])(?:roslaunch|rosrun|rosservice|rostopic|rosparam|rosnode|catkin_make)\s",
        "runs commands of ROS 1, which were not migrated: write them with ros2 or colcon",
        "docs.ros.org, Migrating from ROS 1: ros2 launch, ros2 run, ros2 topic, ros2 service, ros2 param; colcon",
        endings=("", ".sh", ".bash"),
    ),
    _Code(
        r"<launch\b",
        "is a test of rostest, which was not migrated: write it with launch_testing",
        "docs.ros.org, launch_testing: tests that start processes",
        endings=(".test",),
    ),
    _Code(
        r"(?m)^\s*Class: rviz/",
        "is a configuration of RViz 1, which was not migrated: save it anew in RViz 2",
        "docs.ros.org, rviz: the names of its classes differ",
        endings=(".rviz",),
    ),
)


def inventory(
    scratch: Scratch, options: MigrationOptions, changed: Iterable[Change], *, from_ros1: bool
) -> Iterator[ReportLine]:
    """Yield what is left to a person: code that the target does not have, and topics that changed with the controllers.

    changed: what the migration changed. from_ros1: whether the packages were for ROS 1.
    """
    target = options.target
    own = [
        _Code(rf"(?<![\w/]){re.escape(old)}(?![\w/])", f"names '{old}', which is '{new}' now: change it here", OWN)
        for old, new in options.successors.items()
    ]
    yield from _code(scratch, target, own)
    yield from moved_topics(scratch, target, changed, from_ros1=from_ros1)


def _code(scratch: Scratch, target: str, own: Sequence[_Code]) -> Iterator[ReportLine]:
    for path in scratch.files():
        ending = os.path.splitext(path)[1]
        kinds = [code for code in _LOST if ending in code.endings and target in code.distros]
        kinds += own if ending in CODE or os.path.basename(path) == _BUILD_FILE else []
        data = beginning(path) if kinds else b""
        if not data or (not ending and not data.lstrip().startswith(b"#!")):
            continue
        text = data.decode("utf-8", "replace")
        for code in kinds:
            found = re.search(code.pattern, text)
            if found is not None:
                line = text.count("\n", 0, found.end()) + 1
                yield ReportLine(
                    EntryKind.FOR_YOU, code.message, file=scratch.real(path), line=line, authority=code.authority
                )
