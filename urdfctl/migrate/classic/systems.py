"""Plugins of Gazebo Classic that a system of gz replaces, each with the names of its settings in both."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.migrate.edits.markup import child, children, content, indented, span_of
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.startup.records import NamedTuple


class System(NamedTuple):
    """A system of gz.

    filename, name: its library and its class.
    settings: for each setting of Classic, in the spelling of ROS 1 or of ROS 2, its names in gz. One that begins with
        `half:` gets half the value, one with `minus:` its negative, one with `each:` is written for each of its words.
    topics: for each topic of Classic, the setting with its name in gz, and the default name.
    kept: elements that gz reads as they are.
    has_tf: whether it publishes the transform of its odometry on a topic of its own.
    has_axles: whether it needs the measures of the vehicle, which Classic measures itself.
    odometry: the system that publishes its odometry, if it does not do so itself.
    states: the setting of ROS 1 that makes it publish the states of its wheels, which a system of its own does in gz.
    """

    filename: str
    name: str
    settings: Mapping[str, str]
    topics: Mapping[str, tuple[str, str]] = {}
    kept: tuple[str, ...] = ()
    has_tf: bool = False
    has_axles: bool = False
    odometry: System | None = None
    states: str = ""


_ODOMETRY = {
    "updateRate": "odom_publish_frequency",
    "update_rate": "odom_publish_frequency",
    "odometryFrame": "frame_id",
    "odometry_frame": "frame_id",
    "robotBaseFrame": "child_frame_id",
    "robot_base_frame": "child_frame_id",
}
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
    **_ODOMETRY,
}
_DRIVE_TOPICS = {
    "commandTopic": ("topic", "cmd_vel"),
    "command_topic": ("topic", "cmd_vel"),
    "odometryTopic": ("odom_topic", "odom"),
    "odometry_topic": ("odom_topic", "odom"),
}
_DIFF_DRIVE = System("gz-sim-diff-drive-system", "gz::sim::systems::DiffDrive", _DRIVE, _DRIVE_TOPICS, has_tf=True)
_STATES = System(
    "gz-sim-joint-state-publisher-system",
    "gz::sim::systems::JointStatePublisher",
    {"joint_name": "joint_name", "jointName": "each:joint_name"},
    {"topicName": ("topic", "joint_states")},
)
_STATES_OF_WHEELS = _STATES._replace(settings={"leftJoint": "joint_name", "rightJoint": "joint_name"}, topics={})
_ACKERMANN = {
    "rear_left_joint": "left_joint",
    "front_left_joint": "left_joint",
    "rear_right_joint": "right_joint",
    "front_right_joint": "right_joint",
    "left_steering_joint": "left_steering_joint",
    "right_steering_joint": "right_steering_joint",
    "max_steer": "steering_limit",
    "max_speed": "max_velocity minus:min_velocity",
    **_ODOMETRY,
}
_OF_PLANAR_MOVE = System(
    "gz-sim-odometry-publisher-system",
    "gz::sim::systems::OdometryPublisher",
    {
        "odometryFrame": "odom_frame",
        "odometry_frame": "odom_frame",
        "robotBaseFrame": "robot_base_frame",
        "robot_base_frame": "robot_base_frame",
        "odometryRate": "odom_publish_frequency",
        "publish_rate": "odom_publish_frequency",
    },
    {"odometryTopic": ("odom_topic", "odom"), "odometry_topic": ("odom_topic", "odom")},
    has_tf=True,
)
SYSTEMS: Mapping[str, System] = {
    "gazebo_ros_diff_drive": _DIFF_DRIVE._replace(states="publishWheelJointState"),
    "gazebo_ros_skid_steer_drive": _DIFF_DRIVE,
    "gazebo_ros_ackermann_drive": System(
        "gz-sim-ackermann-steering-system",
        "gz::sim::systems::AckermannSteering",
        _ACKERMANN,
        _DRIVE_TOPICS,
        has_tf=True,
        has_axles=True,
    ),
    "gazebo_ros_wheel_slip": System("gz-sim-wheel-slip-system", "gz::sim::systems::WheelSlip", {}, kept=("wheel",)),
    "gazebo_ros_planar_move": System(
        "gz-sim-velocity-control-system",
        "gz::sim::systems::VelocityControl",
        {},
        {"commandTopic": ("topic", "cmd_vel"), "command_topic": ("topic", "cmd_vel")},
        odometry=_OF_PLANAR_MOVE,
    ),
    "gazebo_ros_joint_state_publisher": _STATES,
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
    "gazebo_ros_tricycle_drive",
    "gazebo_ros_force_based_move",
    "gazebo_grasp_fix",
)
"""Plugins of Gazebo Classic that no system of gz replaces one to one."""


_ELSEWHERE = (
    *("ros", "robotNamespace", "publish_odom", "publish_odom_tf", "publishOdomTF", "publishTf", "broadcastTF"),
    *("num_wheel_pairs", "max_wheel_acceleration", "wheelAcceleration", "alwaysOn", "always_on", "legacyMode"),
)
"""Settings of Classic that are read in another way, or that gz needs not."""


def library_of(filename: str) -> str:
    """Return the name of a library without `lib` and `.so`."""
    return filename.rpartition("/")[2].removeprefix("lib").removesuffix(".so")


def _publishes_odometry(element: Element) -> bool:
    """Whether Classic's planar move publishes odometry: always in ROS 1, and in ROS 2 if it is told to
    (gazebo_ros_planar_move.cpp)."""
    told = child(element, "publish_odom")
    return _is_of_ros1(element) if told is None else content(told).lower() in {"true", "1"}


def plain_frame(name: str) -> str:
    """Return the name of a frame without the slash before it, with which tf2 refuses it (buffer_core.cpp)."""
    return name.lstrip("/")


def system_text(element: Element, system: System, step: str, more: Sequence[str] = ()) -> str:
    """Return the `<plugin>` of gz for one of Classic, and one for its odometry. `more` are further lines in the first."""
    lines = [f'<plugin filename="{system.filename}" name="{system.name}">']
    lines += (f"{step}{line}" for line in _settings(element, system))
    lines += (f"{step}{line}" for line in more)
    kept = (one for one in element.elements() if one.tagName in system.kept)
    lines += (line for one in kept for line in indented(flush(one), step).splitlines())
    text = "\n".join([*lines, "</plugin>\n"])
    odometry = system.odometry if _publishes_odometry(element) else None
    text += system_text(element, odometry, step) if odometry is not None else ""
    told = child(element, system.states) if system.states else None
    if told is None or content(told).lower() not in {"true", "1"}:
        return text
    topic = f"<topic>{in_namespace(element, 'joint_states')}</topic>"
    return text + system_text(element, _STATES_OF_WHEELS, step, (topic,))


def flush(element: Element) -> str:
    """Return an element as it is written, with its first line indented by nothing and the others by as much less."""
    lines = span_of(element).text.splitlines()
    margin = min((len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()), default=0)
    return "\n".join([lines[0], *(line[margin:] for line in lines[1:])])


def _settings(element: Element, system: System) -> Iterator[str]:
    once: set[str] = set()
    for setting in element.elements():
        lines = list(_setting(setting, system, once)) if content(setting) else []
        yield from [*comments_above(setting), *lines] if lines else []
    named: set[str] = set()
    for old, (setting_name, default) in system.topics.items():
        if setting_name not in named and (child(element, old) is not None or _is_last(old, system)):
            named.add(setting_name)
            yield f"<{setting_name}>{topic_of(element, old, default)}</{setting_name}>"
    if system.has_tf and _publishes_tf(element):
        yield "<tf_topic>/tf</tf_topic>"
    yield from _acceleration(element) if "wheel_diameter" in system.settings else ()


def _setting(setting: Element, system: System, once: set[str]) -> Iterator[str]:
    """The lines of one setting of Classic, unless its name in gz is among those that are written once."""
    for new in system.settings.get(setting.tagName, "").split():
        way, _, name = new.rpartition(":")
        if name not in once or name.endswith(("_joint", "joint_name")):
            written = plain_frame(content(setting)) if "frame" in name else content(setting)
            yield from (f"<{name}>{value}</{name}>" for value in _values(written, way))
        once.add(name)


def _acceleration(element: Element) -> Iterator[str]:
    """The limit of the acceleration of the base in m/s^2: Classic's compares it with the speed of the wheels' rims
    (gazebo_ros_diff_drive.cpp UpdateWheelVelocities())."""
    names = ("max_wheel_acceleration", "wheelAcceleration")
    found = next((content(one) for name in names if (one := child(element, name)) is not None), "")
    try:
        limit = float(found)
    except ValueError:
        return
    if limit:  # 0 means no limit
        yield f"<max_linear_acceleration>{limit:.6g}</max_linear_acceleration>"
        yield f"<min_linear_acceleration>{-limit:.6g}</min_linear_acceleration>"


def comments_above(element: Element) -> list[str]:
    """Return the comments between an element and the one before it, each as it is written."""
    found: list[str] = []
    node = element.previousSibling
    while isinstance(node, XmlText):
        if node.nodeType == COMMENT:
            found.insert(0, f"<!--{node.data}-->")
        node = node.previousSibling
    return found


def dropped_settings(element: Element, system: System) -> list[str]:
    """Return the settings of Classic that a system of gz does not have, except those that say what is so anyway."""
    odometry = (*system.odometry.settings, *system.odometry.topics) if system.odometry is not None else ()
    known = (*system.settings, *system.topics, *system.kept, *odometry, system.states, *_ELSEWHERE)
    return [one.tagName for one in element.elements() if one.tagName not in known and ":" not in one.tagName]


def _values(text: str, way: str) -> list[str]:
    """The values in gz of a setting of Classic, as `System.settings` says."""
    if way == "each":
        return [word for word in re.split(r"[\s,]+", text) if word]
    return [{"half": halved, "minus": negated}[way](text) if way else text]


def _publishes_tf(element: Element) -> bool:
    """Whether Classic publishes the transform of the odometry: in ROS 1 unless it must not, in ROS 2 if it must."""
    found = (child(element, name) for name in ("publish_odom_tf", "publishOdomTF", "publishTf", "broadcastTF"))
    given = next((content(one).lower() for one in found if one is not None), "")
    return given not in {"false", "0"} if _is_of_ros1(element) else given in {"true", "1"}


def _is_of_ros1(plugin: Element) -> bool:
    return any(one.tagName != one.tagName.lower() for one in plugin.elements())


def _is_last(old: str, system: System) -> bool:
    """Whether no other spelling of the same topic follows in the table."""
    same = [name for name, (setting, _) in system.topics.items() if setting == system.topics[old][0]]
    return same[-1] == old


def topic_of(element: Element, setting: str, default: str) -> str:
    """Return the name of a topic of a plugin: by its own setting, or by the remappings of ROS 2."""
    return in_namespace(element, relative_topic(element, setting, default))


def relative_topic(element: Element, setting: str, default: str) -> str:
    """Return the name of a topic of a plugin without the plugin's namespace."""
    own = child(element, setting)
    if own is not None and content(own):
        return content(own)
    ros = child(element, "ros")
    for remapping in (*children(ros, "remapping"), *children(ros, "argument")) if ros is not None else ():
        old, mark, new = content(remapping).partition(":=")
        if mark and old.strip("~/ ").rpartition("/")[2] == default:
            return new.strip()
    return default


def in_namespace(element: Element, topic: str) -> str:
    """Return the name of a topic in the namespace of its plugin."""
    ros = child(element, "ros")
    space = child(ros, "namespace") if ros is not None else child(element, "robotNamespace")
    prefix = content(space).strip("/") if space is not None else ""
    return f"{prefix}/{topic}" if prefix and not topic.startswith("/") else topic


def negated(text: str) -> str:
    """Return the negative of a number, or of an expression of xacro."""
    whole = re.fullmatch(r"\$\{(.*)\}", text)
    if whole:
        return f"${{-({whole[1].strip()})}}"
    return text[1:] if text.startswith("-") else f"-{text}"


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
