"""Sensors of Gazebo Classic become sensors of gz: their type, topic and frame, without their plugin."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.choice import is_chosen, replaced
from urdfctl.migrate.classic.depth import DEPTH_RANGE, depth_range
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.systems import in_namespace, library_of, relative_topic
from urdfctl.migrate.edits.markup import (
    appended,
    attribute,
    child,
    children,
    content,
    elements,
    indent_of,
    is_zero,
    merged,
    removal,
    root_of,
    span_of,
    step_of,
)
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

_AUTHORITY = "gz-sensors; gazebosim.org, Migrating Gazebo Classic ROS 2 packages"
_FRAMES = ("frameName", "frame_name", "frameId", "frame_id", "bodyName")
_READ = (
    *("ros", "robotNamespace", "cameraName", "camera_name", "alwaysOn", "updateRate", "updateRateHZ", "output_type"),
    *_FRAMES,
)
"""Settings that every sensor has in another way."""


class Sensor(NamedTuple):
    """What a plugin of a sensor publishes.

    types: the type of the sensor in gz for that in Classic.
    topic: the setting of ROS 1 with the topic.
    output: the topic of the plugin in ROS 2, before remapping.
    default: the topic if nothing names it.
    """

    types: Mapping[str, str]
    topic: str
    output: str
    default: str


_LIDAR = Sensor({"ray": "gpu_lidar", "gpu_ray": "gpu_lidar", "lidar": "gpu_lidar"}, "topicName", "out", "scan")
_IMU = Sensor({"imu": "imu"}, "topicName", "out", "imu")
_CAMERA = Sensor({"camera": "camera"}, "imageTopicName", "image_raw", "camera/image_raw")
_DEPTH = Sensor({"depth": "rgbd_camera", "camera": "rgbd_camera"}, "imageTopicName", "image_raw", "camera")
SENSORS: Mapping[str, Sensor] = {
    "gazebo_ros_ray_sensor": _LIDAR,
    "gazebo_ros_laser": _LIDAR,
    "gazebo_ros_gpu_laser": _LIDAR,
    "gazebo_ros_block_laser": _LIDAR,
    "gazebo_ros_range": _LIDAR,
    "gazebo_ros_velodyne_laser": _LIDAR,
    "gazebo_ros_velodyne_gpu_laser": _LIDAR,
    "gazebo_ros_imu_sensor": _IMU,
    "gazebo_ros_camera": Sensor(
        {"camera": "camera", "depth": "rgbd_camera"}, "imageTopicName", "image_raw", "camera/image_raw"
    ),
    "gazebo_ros_openni_kinect": _DEPTH,
    "gazebo_ros_depth_camera": _DEPTH,
    "gazebo_ros_bumper": Sensor({"contact": "contact"}, "bumperTopicName", "bumper_states", "bumper"),
    "gazebo_ros_ft_sensor": Sensor({"force_torque": "force_torque"}, "topicName", "wrench", "wrench"),
    "gazebo_ros_gps_sensor": Sensor({"gps": "navsat"}, "topicName", "out", "navsat"),
}
"""By library of Gazebo Classic: the sensors whose data gz publishes itself."""


def _sensors(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    for path in packages.files(*OF_XML, *OF_SDF):
        source = packages.read(path)
        root = root_of(source) if b"<sensor" in source.data else None
        for element in elements(root) if root is not None else ():
            if element.tagName != "sensor" or is_chosen(element):
                continue
            known = [
                plugin for plugin in children(element, "plugin") if library_of(attribute(plugin, "filename")) in SENSORS
            ]
            kind = attribute(element, "type")
            if known or (kind in _LIDAR.types and kind != "gpu_lidar"):
                yield _migrated(packages, element, known[0] if known else None)


def _migrated(packages: MigratedPackages, element: Element, plugin: Element | None) -> Proposal:
    sensor = SENSORS[library_of(attribute(plugin, "filename"))] if plugin is not None else _LIDAR
    old = attribute(element, "type")
    new = sensor.types.get(old, old)
    source = element.source
    edits = []
    tag = source.start_tag(element.start)
    if tag is not None and "type" in tag.attributes and new != old:
        edits.append(Edit(SourceSpan(source, *tag.attributes["type"]), new))
    ray = child(element, "ray")
    if ray is not None and ray.close is not None:
        start = ray.start + 1
        edits.append(Edit(SourceSpan(source, start, start + 3), "lidar"))
        edits.append(Edit(SourceSpan(source, ray.close + 2, ray.close + 5), "lidar"))
    if plugin is not None:
        topic = child(element, "topic")
        edits += [removal(topic)] if topic is not None and content(topic).startswith("__") else []
        edits.append(removal(plugin))
        edits.append(_settings(element, plugin, sensor, new))
        edits += depth_range(element, plugin) if new == "rgbd_camera" else ()
    text = merged([edit for edit in edits if edit.text or edit.span.start != edit.span.end])
    whole = _applied(element, text)
    message = f"sensor '{attribute(element, 'name')}' became one of type {new} that gz publishes itself"
    entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)]
    if plugin is not None and (dropped := ", ".join(_dropped(element, plugin, sensor, new))):
        message = f"gz does not read {dropped} of '{library_of(attribute(plugin, 'filename'))}': dropped"
        entries.append(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY))
    if old == "ray":
        why = "the sensor is rendered by the GPU: gz has no lidar on the CPU (gz-sensors#26)"
        entries.append(ReportEntry(EntryKind.DECIDED, why, element.at))
    return Proposal(tuple(replaced(packages, element, whole)), entries=tuple(entries))


def _applied(element: Element, edit: Edit) -> str:
    """The text of an element with an edit in it, indented by nothing."""
    span, indent = span_of(element), indent_of(element)
    data = element.source.data
    text = data[span.start : edit.span.start].decode() + edit.text + data[edit.span.end : span.end].decode()
    return "".join(f"{line.removeprefix(indent)}\n" for line in text.splitlines())


def _settings(element: Element, plugin: Element, sensor: Sensor, kind: str) -> Edit:
    """The edit that adds topic, frame and update rate in place of the plugin's settings."""
    indent, step = indent_of(plugin), step_of(element.source)
    lines = []
    topic = child(element, "topic")
    if topic is None or content(topic).startswith("__"):
        lines.append(f"<topic>{_topic(plugin, sensor, kind)}</topic>")
    frame = next((content(one) for name in _FRAMES if (one := child(plugin, name)) is not None and content(one)), "")
    if frame and child(element, "gz_frame_id") is None:
        lines.append(f"<gz_frame_id>{frame}</gz_frame_id>")
    if child(element, "always_on") is None and child(element, "alwaysOn") is None:
        lines.append("<always_on>true</always_on>")
    rate = child(plugin, "updateRate") or child(plugin, "updateRateHZ")
    if rate is not None and child(element, "update_rate") is None:
        lines.append(f"<update_rate>{content(rate)}</update_rate>")
    return appended(element, (f"{indent or step}{line}" for line in lines))


def _dropped(element: Element, plugin: Element, sensor: Sensor, kind: str) -> Iterator[str]:
    """Yield the settings of a plugin that say something, and that gz does not have."""
    kept = {*_READ, sensor.topic, *(DEPTH_RANGE if kind == "rgbd_camera" and depth_range(element, plugin) else ())}
    for setting in plugin.elements():
        if setting.tagName not in kept and ":" not in setting.tagName and not is_zero(setting):
            yield setting.tagName


def _topic(plugin: Element, sensor: Sensor, kind: str) -> str:
    """The topic on which the plugin published; for a camera with depth, what its topics begin with."""
    own = child(plugin, sensor.topic)
    camera = child(plugin, "cameraName") or child(plugin, "camera_name")
    written = content(own) if own is not None else ""
    if not written or written.startswith("__"):  # the default that the plugin's own files name
        written = relative_topic(plugin, sensor.output, sensor.output)
    if written == sensor.output and camera is None:
        written = sensor.default
    name = content(camera) if camera is not None else ""
    if name and not written.startswith(("/", f"{name}/")):
        written = f"{name}/{written}"
    if kind == "rgbd_camera":
        written = written.rpartition("/")[0] or written
    return in_namespace(plugin, written).lstrip("/")


CLASSIC_SENSORS = Step(
    name="classic-sensors",
    part=Part.URDF,
    summary="Sensors of Gazebo Classic",
    propose=_sensors,
    rows=(
        Row('<sensor type="ray">, "gpu_ray"', '<sensor type="gpu_lidar">', "jazzy", _AUTHORITY),
        Row('<sensor type="depth">', '<sensor type="rgbd_camera">', "jazzy", _AUTHORITY),
        *(Row(f"lib{name}.so", "<topic>, <gz_frame_id>", "jazzy", _AUTHORITY) for name in SENSORS),
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="laser" type="ray">
                    <plugin name="laser" filename="libgazebo_ros_ray_sensor.so">
                      <ros>
                        <remapping>~/out:=scan</remapping>
                      </ros>
                      <output_type>sensor_msgs/LaserScan</output_type>
                      <frame_name>fore</frame_name>
                    </plugin>
                  </sensor>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="laser" type="gpu_lidar">
                    <topic>scan</topic>
                    <gz_frame_id>fore</gz_frame_id>
                    <always_on>true</always_on>
                  </sensor>
                </gazebo>
            """,
        },
    ],
)
