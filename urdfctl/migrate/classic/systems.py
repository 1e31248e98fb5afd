"""Plugins of Gazebo Classic that a system of gz replaces, each with the names of its settings in both."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfctl.migrate.markup import child, children, content
from urdfctl.source.dom import Element
from urdfctl.startup.records import NamedTuple


class System(NamedTuple):
    """A system of gz.

    filename, name: its library and its class.
    settings: for each setting of Classic, in the spelling of ROS 1 or of ROS 2, its name in gz. A name that begins with
        `half:` gets half the value.
    topics: for each topic of Classic, the setting with its name in gz, and the default name.
    """

    filename: str
    name: str
    settings: Mapping[str, str]
    topics: Mapping[str, tuple[str, str]] = {}


_DRIVE = {
    "leftJoint": "left_joint",
    "rightJoint": "right_joint",
    "left_joint": "left_joint",
    "right_joint": "right_joint",
    "leftFrontJoint": "left_joint",
    "leftRearJoint": "left_joint",
    "rightFrontJoint": "right_joint",
    "rightRearJoint": "right_joint",
    "wheelSeparation": "wheel_separation",
    "wheel_separation": "wheel_separation",
    "wheelDiameter": "half:wheel_radius",
    "wheel_diameter": "half:wheel_radius",
    "updateRate": "odom_publish_frequency",
    "update_rate": "odom_publish_frequency",
    "odometryFrame": "frame_id",
    "odometry_frame": "frame_id",
    "robotBaseFrame": "child_frame_id",
    "robot_base_frame": "child_frame_id",
}
_DRIVE_TOPICS = {
    "commandTopic": ("topic", "cmd_vel"),
    "command_topic": ("topic", "cmd_vel"),
    "odometryTopic": ("odom_topic", "odom"),
    "odometry_topic": ("odom_topic", "odom"),
}
_DIFF_DRIVE = System("gz-sim-diff-drive-system", "gz::sim::systems::DiffDrive", _DRIVE, _DRIVE_TOPICS)
SYSTEMS: Mapping[str, System] = {
    "gazebo_ros_diff_drive": _DIFF_DRIVE,
    "gazebo_ros_skid_steer_drive": _DIFF_DRIVE,
    "gazebo_ros_planar_move": System(
        "gz-sim-velocity-control-system",
        "gz::sim::systems::VelocityControl",
        {},
        {"commandTopic": ("topic", "cmd_vel"), "command_topic": ("topic", "cmd_vel")},
    ),
    "gazebo_ros_joint_state_publisher": System(
        "gz-sim-joint-state-publisher-system",
        "gz::sim::systems::JointStatePublisher",
        {"joint_name": "joint_name"},
        {"topicName": ("topic", "joint_states")},
    ),
    "gazebo_ros_p3d": System(
        "gz-sim-odometry-publisher-system",
        "gz::sim::systems::OdometryPublisher",
        {
            "bodyName": "robot_base_frame",
            "body_name": "robot_base_frame",
            "frameName": "odom_frame",
            "frame_name": "odom_frame",
            "updateRate": "odom_publish_frequency",
            "update_rate": "odom_publish_frequency",
        },
        {"topicName": ("odom_topic", "odom")},
    ),
}
"""By library of Gazebo Classic, without `lib` and `.so` (gz-sim's header files, gazebo_plugins)."""

NO_SUCCESSOR = (
    "gazebo_ros_vacuum_gripper",
    "gazebo_ros_hand_of_god",
    "gazebo_ros_elevator",
    "gazebo_ros_projector",
    "gazebo_ros_video",
    "gazebo_ros_harness",
    "gazebo_ros_template",
    "gazebo_ros_force",
    "gazebo_ros_ackermann_drive",
    "gazebo_ros_tricycle_drive",
    "gazebo_ros_force_based_move",
    "gazebo_grasp_fix",
)
"""Plugins of Gazebo Classic that no system of gz replaces one to one."""


def library_of(filename: str) -> str:
    """Return the name of a library without `lib` and `.so`."""
    return filename.rpartition("/")[2].removeprefix("lib").removesuffix(".so")


def system_text(element: Element, system: System, step: str) -> str:
    """Return the `<plugin>` of gz for one of Classic."""
    lines = [f'<plugin filename="{system.filename}" name="{system.name}">']
    lines += (f"{step}<{name}>{value}</{name}>" for name, value in _settings(element, system))
    return "\n".join([*lines, "</plugin>\n"])


def _settings(element: Element, system: System) -> Iterator[tuple[str, str]]:
    once: set[str] = set()
    for setting in element.elements():
        new = system.settings.get(setting.tagName)
        if new is None or not content(setting):
            continue
        name = new.removeprefix("half:")
        if name in once and not name.endswith("_joint"):
            continue
        once.add(name)
        yield name, halved(content(setting)) if new.startswith("half:") else content(setting)
    named: set[str] = set()
    for old, (setting_name, default) in system.topics.items():
        if setting_name not in named and (child(element, old) is not None or _is_last(old, system)):
            named.add(setting_name)
            yield setting_name, topic_of(element, old, default)


def _is_last(old: str, system: System) -> bool:
    """Whether no other spelling of the same topic follows in the table."""
    same = [name for name, (setting, _) in system.topics.items() if setting == system.topics[old][0]]
    return same[-1] == old


def topic_of(element: Element, setting: str, default: str) -> str:
    """Return the name of a topic of a plugin: by its own setting, or by the remappings of ROS 2."""
    own = child(element, setting)
    if own is not None and content(own):
        return content(own)
    ros = child(element, "ros")
    for remapping in (*children(ros, "remapping"), *children(ros, "argument")) if ros is not None else ():
        old, mark, new = content(remapping).partition(":=")
        if mark and old.strip("~/ ") == default:
            return new.strip()
    return default


def halved(text: str) -> str:
    """Return half of a number, or of an expression of xacro."""
    whole = re.fullmatch(r"\$\{(.*)\}", text)
    if whole:
        inner = whole[1].strip()
        return f"${{{inner} / 2}}" if inner.isidentifier() else f"${{({inner}) / 2}}"
    try:
        return repr(float(text) / 2)
    except ValueError:
        return f"${{({text}) / 2}}"
