"""The file for ros_gz_bridge: what the systems and sensors of gz publish and read, in ROS."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.generate.files.bringup import gz_names
from urdfctl.load.loader import LoadedTarget
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.sensor_topics import SENSORS, Sensor, SensorPlugin, plugin_as_expanded, plugin_as_written
from urdfctl.migrate.classic.systems import library_of
from urdfctl.migrate.edits.markup import MACRO, ancestors, attribute, child, children, content, elements, root_of
from urdfctl.migrate.edits.places import key_of, key_of_element, written_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz, leaves_classic
from urdfctl.migrate.shared.install_rules import BRIDGE_FILE
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.model.robot import Tag
from urdfctl.source.disk.gate import exists
from urdfctl.source.opaque import is_known
from urdfctl.source.span import SourceText
from urdfctl.source.workspaces.packages import package_around
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_AUTHORITY = "ros_gz_bridge README: config_file"


class Topic(NamedTuple):
    """A topic to bridge: its name in gz, its type in ROS and in gz, whether ROS sends it, and its name in ROS if that
    is another one."""

    name: str
    ros: str
    gz: str
    from_ros: bool = False
    in_ros: str = ""


_OF_SYSTEMS = {
    "topic": ("geometry_msgs/msg/Twist", "Twist", True),
    "odom_topic": ("nav_msgs/msg/Odometry", "Odometry", False),
    "tf_topic": ("tf2_msgs/msg/TFMessage", "Pose_V", False),
}
_DRIVES = (
    "gz-sim-ackermann-steering-system",
    "gz-sim-diff-drive-system",
    "gz-sim-mecanum-drive-system",
    "gz-sim-odometry-publisher-system",
    "gz-sim-velocity-control-system",
)
_STATES = "gz-sim-joint-state-publisher-system"
_OF_SENSORS: dict[str, tuple[tuple[str, str, str], ...]] = {
    "gpu_lidar": (
        ("", "sensor_msgs/msg/LaserScan", "LaserScan"),
        ("/points", "sensor_msgs/msg/PointCloud2", "PointCloudPacked"),
    ),
    "imu": (("", "sensor_msgs/msg/Imu", "IMU"),),
    "camera": (("", "sensor_msgs/msg/Image", "Image"), ("../camera_info", "sensor_msgs/msg/CameraInfo", "CameraInfo")),
    "rgbd_camera": (
        ("/image", "sensor_msgs/msg/Image", "Image"),
        ("/depth_image", "sensor_msgs/msg/Image", "Image"),
        ("/camera_info", "sensor_msgs/msg/CameraInfo", "CameraInfo"),
        ("/points", "sensor_msgs/msg/PointCloud2", "PointCloudPacked"),
    ),
    "navsat": (("", "sensor_msgs/msg/NavSatFix", "NavSat"),),
    "contact": (("", "ros_gz_interfaces/msg/Contacts", "Contacts"),),
    "force_torque": (("", "geometry_msgs/msg/WrenchStamped", "Wrench"),),
}
"""For each type of sensor: the ending of a topic, its type in ROS and in gz."""
_UNASKED = frozenset({("gpu_lidar", "/points")})
"""Topics that no plugin of Gazebo Classic publishes unless it is told to."""


def _bridge(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages) or not leaves_classic(packages):
        return
    for folder in sorted(
        {folder for path in packages.files(*OF_XML, *OF_SDF) if (folder := package_around(os.path.dirname(path)))}
    ):
        path = os.path.join(folder, BRIDGE_FILE)
        if exists(path) or _has_bridge(packages):
            if packages.found(_had_bridge):
                yield from _unbridged(packages, folder)
            continue
        found = (
            topic._replace(name=_valid(topic.name), in_ros=_valid(topic.in_ros)) for topic in _topics(packages, folder)
        )
        topics = list(dict.fromkeys(found))
        entries = list(_unnamed(packages, folder))
        if topics:
            message = f"{len(topics)} topics of gz are bridged to ROS"
            entries.append(ReportEntry(EntryKind.DONE, message, file=path, authority=_AUTHORITY))
        if entries:
            created = ((path, _text(packages, topics)),) if topics else ()
            yield Proposal(created=created, entries=tuple(entries))


def _unbridged(packages: MigratedPackages, folder: str) -> Iterator[Proposal]:
    """Tell the topics of sensors of a robot that Gazebo Classic simulated, where only other launch files have a bridge."""
    names = packages.found(_names_in_ros)
    for loaded in packages.loaded():
        launch = loaded.project.launch
        is_bridged = any(b"parameter_bridge" in packages.scratch.original(path) for path in loaded.sources)
        if launch is None or is_bridged or not packages.is_of_classic(loaded):
            continue
        tags = ((tag, {one.name: one.text for one in tag.children}) for tag in _in_gazebo(loaded, "plugin", "sensor"))
        own = [one for one in tags if one[0].at.source.path.startswith(folder + os.sep)]
        found = dict.fromkeys(
            topic.name for tag, texts in own for topic in _of_element(tag.name, tag.attributes, texts, names)
        )
        if found and own:
            names_of_topics = ", ".join(f"'{name}'" for name in found)
            what = f"start a bridge of {names_of_topics} here, too: only other launch files do"
            yield Proposal(entries=(ReportEntry(EntryKind.FOR_YOU, what, file=launch.path, authority=_AUTHORITY),))


def _valid(name: str) -> str:
    """A topic without empty parts, and without a private part but the first: others end the bridge (rcl,
    RCL_TOPIC_NAME_INVALID_MISPLACED_TILDE)."""
    return re.sub("//+", "/", re.sub("(?<=.)/~(?=/)", "", name))


def _has_bridge(packages: MigratedPackages) -> bool:
    """Whether the packages already start a bridge, with topics of their own."""
    return packages.found(_starts_bridge)


def _starts_bridge(packages: MigratedPackages) -> bool:
    return any(b"parameter_bridge" in packages.read(path).data for path in packages.files(".py", ".launch.xml"))


def _had_bridge(packages: MigratedPackages) -> bool:
    """Whether they already started one before they were migrated."""
    files = packages.files(".py", ".launch.xml", ".launch")
    return any(b"parameter_bridge" in packages.scratch.original(path) for path in files)


def _topics(packages: MigratedPackages, folder: str) -> Iterator[Topic]:
    """The topics of the files of a package: as they are written, with the defaults of arguments, and as its robots have
    them."""
    names = packages.found(_names_in_ros)
    for element, texts in _written(packages, folder):
        yield from _of_element(element.tagName, element.attrs, texts, names)
    for tag, texts in _expanded(packages, folder):
        yield from _of_element(tag.name, tag.attributes, texts, names)


def _written(packages: MigratedPackages, folder: str) -> Iterator[tuple[Element, dict[str, str]]]:
    """The plugins and sensors of the files of a package as they are written, each with the texts of its children."""
    defaults = packages.found(_defaults)
    for path in packages.files(*OF_XML, *OF_SDF):
        source = packages.read(path)
        is_simulated = b"<gazebo" in source.data or path.endswith(OF_SDF)
        root = root_of(source) if path.startswith(folder + os.sep) and is_simulated else None
        for element in elements(root) if root is not None else ():
            if element.tagName in {"plugin", "sensor"} and not _is_uncalled(packages, element):
                written = {each.tagName: each for each in (*_in_contact(element), *element.elements())}
                yield element, {name: _with_defaults(content(each), defaults) for name, each in written.items()}


def _expanded(packages: MigratedPackages, folder: str) -> Iterator[tuple[Tag, dict[str, str]]]:
    """The plugins and sensors of a package as its robots have them, each with the texts of its children."""
    for loaded in packages.loaded():
        for tag in _in_gazebo(loaded, "plugin", "sensor"):
            if tag.at.source.path.startswith(folder + os.sep):
                inner = (each for one in tag.named("contact") for each in one.named("topic"))
                yield tag, {each.name: each.text for each in (*inner, *tag.children)}


def _in_gazebo(loaded: LoadedTarget, *names: str) -> Iterator[Tag]:
    """The elements with some names in the <gazebo> elements of a robot, also in links that are written there as SDF."""
    pending = [gazebo.tag for gazebo in loaded.project.robot.gazebos] if loaded.project.robot else []
    while pending:
        tag = pending.pop(0)
        if tag.name in names:
            yield tag
        pending += tag.children


def _unnamed(packages: MigratedPackages, folder: str) -> Iterator[ReportEntry]:
    """Yield the topics that are not bridged, because their names depend on an argument that no robot has a value of."""
    bridged = {
        key_of(tag.at) for tag, texts in _expanded(packages, folder) if _has_topics(tag.name, tag.attributes, texts)
    }
    for element, texts in _written(packages, folder):
        is_known = key_of_element(element) in bridged
        for name in _topic_settings(element.tagName, element.attrs) if not is_known else ():
            if "$(arg" in texts.get(name, ""):
                message = (
                    f"topic '{texts[name]}' is not bridged: add it to {BRIDGE_FILE} with the value of the argument"
                )
                yield ReportEntry(EntryKind.FOR_YOU, message, element.at, authority=_AUTHORITY)


def _has_topics(name: str, attributes: Mapping[str, str], texts: Mapping[str, str]) -> bool:
    return any(_is_plain(texts.get(setting, "")) for setting in _topic_settings(name, attributes))


def _topic_settings(name: str, attributes: Mapping[str, str]) -> Sequence[str]:
    """The settings of a plugin or sensor that name topics."""
    if name == "sensor":
        return ("topic",) if attributes.get("type") in _OF_SENSORS else ()
    filename = attributes.get("filename", "")
    return tuple(_OF_SYSTEMS) if filename in _DRIVES else ("topic",) if filename == _STATES else ()


def _is_uncalled(packages: MigratedPackages, element: Element) -> bool:
    """Whether an element is in a macro that nothing calls, although a robot of the packages reads its file."""
    macro = next((one for one in ancestors(element) if one.tagName == MACRO), None)
    name = attribute(macro, "name").removeprefix("xacro:") if macro is not None else ""
    path = element.source.path
    return bool(name) and name not in packages.found(_called) and path in packages.found(_read_by_robots)


def _called(packages: MigratedPackages) -> frozenset[str]:
    """The names of the macros that are called, without those of namespaces."""
    roots = (root_of(packages.read(path)) for path in packages.files(*OF_XML))
    every = (one for root in roots if root is not None for one in elements(root))
    return frozenset(
        attribute(one, "macro")
        if one.tagName == "xacro:call"
        else one.tagName.removeprefix("xacro:").rpartition(".")[2]
        for one in every
        if one.tagName.startswith("xacro:")
    )


def _read_by_robots(packages: MigratedPackages) -> frozenset[str]:
    robots = (loaded for loaded in packages.loaded() if loaded.project.robot and not loaded.project.library)
    return frozenset(path for loaded in robots for path in loaded.sources)


def _in_contact(sensor: Element) -> Iterator[Element]:
    """The topic of a contact sensor."""
    around = child(sensor, "contact")
    topic = child(around, "topic") if around is not None else None
    return iter(() if topic is None else (topic,))


def _names_in_ros(packages: MigratedPackages) -> dict[str, list[tuple[str, str]]]:
    """The names in ROS that sensors had before the migration, by their topic in gz: each after an ending of that."""
    found: dict[str, list[tuple[str, str]]] = {}
    for plugin, known, kind in (*_before_as_written(packages), *_before_as_expanded(packages)):
        topic = plugin.in_gz(known, kind, is_ros1=packages.is_ros1)
        found.setdefault(_key(topic), list(plugin.in_ros(known, kind, is_ros1=packages.is_ros1)))
    return found


def _key(topic: str) -> str:
    return "/".join(filter(None, topic.split("/")))


def _before_as_written(packages: MigratedPackages) -> Iterator[tuple[SensorPlugin, Sensor, str]]:
    defaults = packages.found(_defaults)
    for path in packages.files(*OF_XML, *OF_SDF):
        data = packages.scratch.original(path)
        root = root_of(SourceText(path, data)) if b"<sensor" in data else None
        for element in elements(root) if root is not None else ():
            for plugin in children(element, "plugin") if element.tagName == "sensor" else ():
                library = library_of(attribute(plugin, "filename"))
                kind = SENSORS[library].types.get(attribute(element, "type"), "") if library in SENSORS else ""
                if kind:
                    one = plugin_as_written(plugin, element, library)
                    given = {name: _with_defaults(text, defaults) for name, text in one.settings.items()}
                    space = _with_defaults(one.space, defaults).strip("/")
                    yield one._replace(settings=given, space=space), SENSORS[library], kind


def _before_as_expanded(packages: MigratedPackages) -> Iterator[tuple[SensorPlugin, Sensor, str]]:
    for loaded in packages.robots_before:
        for sensor in _in_gazebo(loaded, "sensor"):
            for plugin in sensor.named("plugin"):
                library = library_of(plugin.attributes.get("filename", ""))
                kind = SENSORS[library].types.get(sensor.attributes.get("type", ""), "") if library in SENSORS else ""
                if kind:
                    yield plugin_as_expanded(plugin, sensor, library), SENSORS[library], kind


def _defaults(packages: MigratedPackages) -> dict[str, str]:
    """The defaults of the arguments of descriptions, without those that differ between files."""
    found: dict[str, set[str]] = {}
    for element in written_elements(packages, "<xacro:arg"):
        if element.tagName == "xacro:arg":
            found.setdefault(attribute(element, "name"), set()).add(attribute(element, "default"))
    return {name: next(iter(values)) for name, values in found.items() if len(values) == 1}


def _with_defaults(text: str, defaults: Mapping[str, str]) -> str:
    return re.sub(r"\$\(arg\s+(\w+)\s*\)", lambda match: defaults.get(match[1], match[0]), text)


def _of_element(
    name: str,
    attributes: Mapping[str, str],
    texts: Mapping[str, str],
    names: Mapping[str, Sequence[tuple[str, str]]],
) -> Iterator[Topic]:
    """The topics of a plugin or sensor.

    texts: the texts of its children by name.
    names: of sensors in ROS, as `_names_in_ros` says.
    """
    if name == "plugin":
        yield from _of_plugin(attributes.get("filename", ""), texts)
        return
    topic, kind = texts.get("topic", ""), attributes.get("type", "")
    pairs = names.get(_key(topic), ())
    known = dict(reversed(pairs))
    for ending, ros, gz in _OF_SENSORS.get(kind, ()) if _is_plain(topic) else ():
        if ending in known if known else (kind, ending) not in _UNASKED:
            above = topic.rpartition("/")[0]
            beside = f"{above}/{ending[3:]}".lstrip("/")
            in_gz = beside if ending.startswith("../") else f"{topic}{ending}"
            in_ros = known.get(ending, "")
            is_same = _key(in_ros) == _key(in_gz) and (in_gz.startswith("/") or not in_ros.startswith("/"))
            yield Topic(in_gz, ros, gz, in_ros=in_ros if _is_plain(in_ros) and not is_same else "")
            more = (name for its, name in pairs if its == ending and name != in_ros and _is_plain(name))
            yield from (Topic(in_gz, ros, gz, in_ros=name) for name in more)


def _of_plugin(filename: str, texts: Mapping[str, str]) -> Iterator[Topic]:
    for setting, (ros, gz, from_ros) in _OF_SYSTEMS.items():
        if filename in _DRIVES and _is_plain(texts.get(setting, "")):
            yield Topic(texts[setting], ros, gz, from_ros)
    if filename == _STATES and _is_plain(texts.get("topic", "")):
        yield Topic(texts["topic"], "sensor_msgs/msg/JointState", "Model")


def _is_plain(name: str) -> bool:
    """Whether a topic is known without the arguments of xacro."""
    return bool(name) and "$" not in name and is_known(name)


def _text(packages: MigratedPackages, topics: list[Topic]) -> str:
    messages = gz_names(packages.options.target)["messages"]
    clock = Topic("/clock", "rosgraph_msgs/msg/Clock", "Clock")
    blocks = ["# The topics between ROS and gz, for parameter_bridge of ros_gz_bridge.\n"]
    for topic in (clock, *topics):
        way = "ROS_TO_GZ" if topic.from_ros else "GZ_TO_ROS"
        in_gz, in_ros = (f'"{each}"' if each.startswith("~") else each for each in (topic.name, topic.in_ros))
        blocks.append(
            f"- ros_topic_name: {in_ros or in_gz}\n  gz_topic_name: {in_gz}\n  ros_type_name: {topic.ros}\n"
            f"  gz_type_name: {messages}.{topic.gz}\n  direction: {way}\n"
        )
    return "".join(blocks)


BRIDGE = Step(
    name="bridge",
    part=Part.YAML,
    summary="Topics between ROS and gz",
    propose=_bridge,
    rows=(Row("topics that plugins published in ROS", f"{BRIDGE_FILE} for ros_gz_bridge", "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="laser" type="gpu_lidar">
                    <topic>scan</topic>
                  </sensor>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "config/bridge.yaml": """
                # The topics between ROS and gz, for parameter_bridge of ros_gz_bridge.
                - ros_topic_name: /clock
                  gz_topic_name: /clock
                  ros_type_name: rosgraph_msgs/msg/Clock
                  gz_type_name: gz.msgs.Clock
                  direction: GZ_TO_ROS
                - ros_topic_name: scan
                  gz_topic_name: scan
                  ros_type_name: sensor_msgs/msg/LaserScan
                  gz_type_name: gz.msgs.LaserScan
                  direction: GZ_TO_ROS
            """,
        },
    ],
)
