"""The topics of a sensor in Gazebo Classic: what its plugin publishes in ROS, and where gz publishes the same."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.migrate.edits.markup import attribute, child, children, content, is_zero
from urdfctl.model.robot import Tag
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple


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
PLAIN_LIDAR = _LIDAR
"""A lidar without a plugin."""
_CLOUDS = ("gazebo_ros_block_laser", "gazebo_ros_velodyne_laser", "gazebo_ros_velodyne_gpu_laser")
_OF_CAMERAS: Mapping[str, Sequence[tuple[str, str, str]]] = {
    "camera": (("", "imageTopicName", "image_raw"), ("../camera_info", "cameraInfoTopicName", "camera_info")),
    "rgbd_camera": (
        ("/image", "imageTopicName", "image_raw"),
        ("/depth_image", "depthImageTopicName", "depth/image_raw"),
        ("/camera_info", "cameraInfoTopicName", "camera_info"),
        ("/points", "pointCloudTopicName", "points"),
    ),
}
"""By type in gz: the ending of a topic in gz, its setting in ROS 1, and its name in ROS 2 below that of the camera."""
_OF_DEPTH = ("/camera_info", "depthImageCameraInfoTopicName", "depth/camera_info")
"""The same again for the image of the depth (gazebo_plugins, ROS 1: gazebo_ros_openni_kinect.cpp, and
gazebo_ros_depth_camera.cpp): gz has one camera with both images."""


class SensorPlugin(NamedTuple):
    """The plugin of a sensor, as it is written or as it is expanded.

    library: without `lib` and `.so`.
    sensor: the name of the sensor.
    settings: its settings of one level, by name.
    remappings: what it remaps in ROS 2, without blanks and slashes before the old names.
    space: its namespace.
    """

    library: str
    sensor: str
    settings: Mapping[str, str]
    remappings: Mapping[str, str]
    space: str

    @property
    def is_cloud(self) -> bool:
        """Whether a lidar publishes a cloud of points instead of a scan."""
        output = self.settings.get("output_type", "PointCloud2" if self.library == "gazebo_ros_ray_sensor" else "")
        return "PointCloud" in output or self.library in _CLOUDS

    @property
    def is_range(self) -> bool:
        """Whether a lidar publishes one distance instead of a scan."""
        return self.library == "gazebo_ros_range" or self.settings.get("output_type", "").endswith("Range")

    def in_gz(self, known: Sensor, kind: str, *, is_ros1: bool) -> str:
        """Return the topic of the sensor in gz; for a camera with depth, what its topics begin with."""
        name = self._name(known, kind, is_ros1=is_ros1)
        if kind == "rgbd_camera":
            name = name.rpartition("/")[0] or name
        return name.lstrip("/")

    def in_ros(self, known: Sensor, kind: str, *, is_ros1: bool) -> Iterator[tuple[str, str]]:
        """Yield the topics of the sensor in ROS, each after the ending of that in gz; an ending may have several."""
        if kind not in _OF_CAMERAS:
            yield "/points" if kind == "gpu_lidar" and self.is_cloud else "", self._name(known, kind, is_ros1=is_ros1)
            return
        has_both = is_ros1 and SENSORS.get(self.library) is _DEPTH
        for ending, setting, output in (*_OF_CAMERAS[kind], *([_OF_DEPTH] if has_both else ())):
            yield ending, self._in_space(self._of_camera(setting, output, is_ros1=is_ros1))

    def _name(self, known: Sensor, kind: str, *, is_ros1: bool) -> str:
        if kind in _OF_CAMERAS:
            return self._in_space(self._of_camera(known.topic, known.output, is_ros1=is_ros1))
        written, remapped = self._set(known.topic), self.remappings.get(known.output, "")
        return self._in_space((written or remapped if is_ros1 else remapped or written) or known.default)

    def _of_camera(self, setting: str, output: str, *, is_ros1: bool) -> str:
        """A topic of a camera: in ROS 2 below the camera's name, which is that of its sensor unless it has one."""
        camera = self.settings.get("cameraName", "") or self.settings.get("camera_name", "")
        camera = camera.strip("/") or ("" if is_ros1 else self.sensor)
        written = self._set(setting) or output
        plain = f"{camera}/{written}" if camera and not written.startswith(("/", f"{camera}/")) else written
        return self.remappings.get(plain, plain)

    def _set(self, setting: str) -> str:
        """A setting; nothing for the default that the plugin's own files name."""
        written = self.settings.get(setting, "")
        return "" if written.startswith("__") else written

    def _in_space(self, name: str) -> str:
        return f"{self.space}/{name}" if self.space and not name.startswith("/") else name


def plugin_as_written(plugin: Element, sensor: Element, library: str) -> SensorPlugin:
    """Return the plugin of a sensor with the texts of its file."""
    ros = child(plugin, "ros")
    inner = [*children(ros, "remapping"), *children(ros, "argument")] if ros is not None else []
    space = child(ros, "namespace") if ros is not None else child(plugin, "robotNamespace")
    settings = {one.tagName: content(one) for one in plugin.elements()}
    texts = [content(one) for one in inner]
    remappings = _remappings(texts, attribute(plugin, "name"))
    return SensorPlugin(library, attribute(sensor, "name"), settings, remappings, _space(space))


def plugin_as_expanded(plugin: Tag, sensor: Tag, library: str) -> SensorPlugin:
    """Return the plugin of a sensor with the texts that xacro makes of its file."""
    ros = next(plugin.named("ros"), None)
    inner = [one.text for name in ("remapping", "argument") for one in ros.named(name)] if ros is not None else []
    space = next(ros.named("namespace") if ros is not None else plugin.named("robotNamespace"), None)
    settings = {one.name: one.text.strip() for one in plugin.children}
    name = sensor.attributes.get("name", "")
    remappings = _remappings(inner, plugin.attributes.get("name", ""))
    return SensorPlugin(library, name, settings, remappings, space.text.strip().strip("/") if space else "")


def _space(element: Element | None) -> str:
    return content(element).strip("/") if element is not None else ""


def _remappings(texts: Sequence[str], plugin: str) -> Mapping[str, str]:
    """The remappings of a plugin; the topic `~/out` is also written below the plugin's name, which is its node's."""
    pairs = (text.partition(":=") for text in texts)
    found = {old.strip().removeprefix("~").strip("/ "): new.strip() for old, mark, new in pairs if mark and new.strip()}
    private = found.get(f"{plugin}/out")
    return {"out": private, **found} if private else found


def unread(plugin: Element, known: Sensor, kind: str, kept: Sequence[str]) -> Iterator[str]:
    """Yield the settings of a plugin that say something, and that gz does not have."""
    topics = (setting for _, setting, _ in _OF_CAMERAS.get(kind, ()))
    read = {*kept, known.topic, *topics, _OF_DEPTH[1]}
    for setting in plugin.elements():
        if setting.tagName not in read and ":" not in setting.tagName and not is_zero(setting):
            yield setting.tagName
