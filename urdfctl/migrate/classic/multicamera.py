"""A sensor with several cameras, which gz does not have, becomes a sensor for each camera."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.migrate.classic.choice import is_chosen, replaced
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.systems import flush, library_of
from urdfctl.migrate.edits.markup import attribute, child, children, content, elements, indented, root_of, step_of
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import OF_XML, MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gz-sim src/systems/sensors/Sensors.cc: no sensor of type multicamera"
_LIBRARIES = ("gazebo_ros_multicamera", "gazebo_ros_camera")
_NAMES = ("camera_name", "cameraName")


def _cameras(packages: MigratedPackages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    for path in packages.files(*OF_XML, *OF_SDF):
        source = packages.read(path)
        root = root_of(source) if b"multicamera" in source.data else None
        for element in elements(root) if root is not None else ():
            cameras = list(children(element, "camera")) if element.tagName == "sensor" else []
            plugin = child(element, "plugin")
            is_known = plugin is None or library_of(attribute(plugin, "filename")) in _LIBRARIES
            if attribute(element, "type") == "multicamera" and cameras and is_known and not is_chosen(element):
                text = "".join(_sensor(element, camera, plugin) for camera in cameras)
                message = (
                    f"sensor '{attribute(element, 'name')}' became a sensor for each of its {len(cameras)} cameras"
                )
                entry = ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)
                yield Proposal(tuple(replaced(packages, element, text)), entries=(entry,))


def _sensor(element: Element, camera: Element, plugin: Element | None) -> str:
    """The sensor of one camera, in the form of Gazebo Classic."""
    step, own = step_of(element.source), attribute(camera, "name")
    pose = child(camera, "pose")
    lens = flush(camera) if pose is None else re.sub(r"(?s)\n?[ \t]*<pose\b.*?</pose>", "", flush(camera), count=1)
    kept = [one for one in element.elements() if one is not plugin and one.tagName != "camera"]
    kept = [one for one in kept if pose is None or one.tagName != "pose"]
    parts = [flush(one) for one in kept] + ([flush(pose)] if pose is not None else []) + [lens]
    if plugin is not None:
        parts.append(_plugin(plugin, attribute(element, "name"), own))
    inner = "".join(indented(f"{part}\n", step) for part in parts)
    return f'<sensor name="{attribute(element, "name")}_{own}" type="camera">\n{inner}</sensor>\n'


def _plugin(plugin: Element, sensor: str, camera: str) -> str:
    """The plugin of one camera, whose topics are below the name of the sensor and that of the camera."""
    text = flush(plugin).replace(_LIBRARIES[0], _LIBRARIES[1])
    named = next((one for name in _NAMES if (one := child(plugin, name)) is not None and content(one)), None)
    if named is not None:
        old = f"<{named.tagName}>{content(named)}"
        return re.sub(rf"<{named.tagName}>\s*{re.escape(content(named))}", lambda _: f"{old}/{camera}", text, count=1)
    head, close, tail = text.rpartition("</plugin>")
    name = f"<camera_name>{sensor}/{camera}</camera_name>"
    return f"{head.rstrip()}\n{step_of(plugin.source)}{name}\n{close}{tail}" if close else text


MULTICAMERA = Step(
    name="classic-multicamera",
    part=Part.URDF,
    summary="Sensors of Gazebo Classic with several cameras",
    propose=_cameras,
    rows=(Row('<sensor type="multicamera">', 'a <sensor type="camera"> for each', "jazzy", _AUTHORITY),),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo reference="head">
                  <sensor name="eyes" type="multicamera">
                    <update_rate>30</update_rate>
                    <camera name="left">
                      <pose>0 0.1 0 0 0 0</pose>
                      <horizontal_fov>1.3</horizontal_fov>
                    </camera>
                    <camera name="right">
                      <horizontal_fov>1.3</horizontal_fov>
                    </camera>
                    <plugin name="eyes" filename="libgazebo_ros_multicamera.so">
                      <cameraName>stereo</cameraName>
                    </plugin>
                  </sensor>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo reference="head">
                  <sensor name="eyes_left" type="camera">
                    <update_rate>30</update_rate>
                    <pose>0 0.1 0 0 0 0</pose>
                    <camera name="left">
                      <horizontal_fov>1.3</horizontal_fov>
                    </camera>
                    <plugin name="eyes" filename="libgazebo_ros_camera.so">
                      <cameraName>stereo/left</cameraName>
                    </plugin>
                  </sensor>
                  <sensor name="eyes_right" type="camera">
                    <update_rate>30</update_rate>
                    <camera name="right">
                      <horizontal_fov>1.3</horizontal_fov>
                    </camera>
                    <plugin name="eyes" filename="libgazebo_ros_camera.so">
                      <cameraName>stereo/right</cameraName>
                    </plugin>
                  </sensor>
                </gazebo>
            """,
        },
    ],
)
