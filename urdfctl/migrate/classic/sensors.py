"""Sensors of Gazebo Classic become sensors of gz: their type, topic and frame, without their plugin."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.choice import is_chosen, replaced
from urdfctl.migrate.classic.depth import DEPTH_RANGE, depth_range
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.sensor_topics import PLAIN_LIDAR, SENSORS, plugin_as_written, unread
from urdfctl.migrate.classic.systems import library_of, plain_frame
from urdfctl.migrate.edits.markup import (
    CONDITIONS,
    appended,
    attribute,
    child,
    children,
    content,
    elements,
    indent_of,
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

_AUTHORITY = "gz-sensors; gazebosim.org, Migrating Gazebo Classic ROS 2 packages"
_FRAMES = ("frameName", "frame_name", "frameId", "frame_id", "bodyName")
_READ = (
    *("ros", "robotNamespace", "cameraName", "camera_name", "alwaysOn", "updateRate", "updateRateHZ", "output_type"),
    *_FRAMES,
)
"""Settings that every sensor has in another way."""


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
            if known or (kind in PLAIN_LIDAR.types and kind != "gpu_lidar"):
                yield _migrated(packages, element, known[0] if known else None)


def _migrated(packages: MigratedPackages, element: Element, plugin: Element | None) -> Proposal:
    sensor = SENSORS[library_of(attribute(plugin, "filename"))] if plugin is not None else PLAIN_LIDAR
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
        edits += _settings(element, plugin, _topic(packages, element, plugin, new), new)
        edits += depth_range(element, plugin) if new == "rgbd_camera" else ()
    text = merged([edit for edit in edits if edit.text or edit.span.start != edit.span.end])
    whole = _applied(element, text)
    message = f"sensor '{attribute(element, 'name')}' became one of type {new} that gz publishes itself"
    entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)]
    range_read = DEPTH_RANGE if plugin is not None and new == "rgbd_camera" and depth_range(element, plugin) else ()
    kept = (*_READ, *range_read)
    if plugin is not None and (dropped := ", ".join(unread(plugin, sensor, new, kept))):
        message = f"gz does not read {dropped} of '{library_of(attribute(plugin, 'filename'))}': dropped"
        entries.append(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY))
    if plugin is not None:
        entries += _other_messages(element, plugin, new)
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


def _settings(element: Element, plugin: Element, topic: str, kind: str) -> Iterator[Edit]:
    """Yield the edits that add topic, frame and update rate in place of the plugin's settings.

    The topic of a contact sensor is in its <contact> (gz-sim src/systems/contact/Contact.cc Load()).
    """
    indent, step = indent_of(plugin), step_of(element.source)
    lines = []
    written = child(element, "topic")
    around = child(element, "contact") if kind == "contact" else None
    if around is not None and around.close is not None:
        if child(around, "topic") is None:
            yield appended(around, [f"{indent_of(around)}{step}<topic>{topic}</topic>"])
    elif written is None or content(written).startswith("__"):
        lines.append(f"<topic>{topic}</topic>")
    if child(element, "gz_frame_id") is None:
        lines += _frames(plugin, step)
    if child(element, "always_on") is None and child(element, "alwaysOn") is None:
        lines.append("<always_on>true</always_on>")
    rate = child(plugin, "updateRate") or child(plugin, "updateRateHZ")
    if rate is not None and child(element, "update_rate") is None:
        lines.append(f"<update_rate>{content(rate)}</update_rate>")
    yield from _slower(element, plugin)
    yield appended(element, (f"{indent or step}{line}" for line in lines))


def _slower(element: Element, plugin: Element) -> Iterator[Edit]:
    """The edit that gives a sensor the rate of its plugin, which published less often (gazebo_ros_imu_sensor.cpp, ROS 1)."""
    own, rate = child(element, "update_rate"), child(plugin, "updateRateHZ")
    if own is not None and rate is not None and 0 < _number(content(rate)) < _number(content(own)):
        span = span_of(own)
        yield Edit(span, span.text.replace(content(own), content(rate)))


def _number(text: str) -> float:
    """A number; 0 for a text that is none, as an argument."""
    return float(text) if re.fullmatch(r"\d+(\.\d*)?", text) else 0.0


def _frames(plugin: Element, step: str) -> Iterator[str]:
    """The lines with the frame that a plugin names, also within conditions of xacro."""
    frame = _frame(plugin)
    if frame:
        yield f"<gz_frame_id>{frame}</gz_frame_id>"
        return
    for choice in plugin.elements():
        if choice.tagName in CONDITIONS and (chosen := _frame(choice)):
            yield f'<{choice.tagName} value="{attribute(choice, "value")}">'
            yield from (f"{step}<gz_frame_id>{chosen}</gz_frame_id>", f"</{choice.tagName}>")


def _frame(around: Element) -> str:
    return plain_frame(
        next((content(one) for name in _FRAMES if (one := child(around, name)) is not None and content(one)), "")
    )


def _topic(packages: MigratedPackages, element: Element, plugin: Element, kind: str) -> str:
    """The topic of a sensor in gz."""
    library = library_of(attribute(plugin, "filename"))
    return plugin_as_written(plugin, element, library).in_gz(SENSORS[library], kind, is_ros1=packages.is_ros1)


def _other_messages(element: Element, plugin: Element, kind: str) -> Iterator[ReportEntry]:
    """What a person must know of a sensor whose messages are of another type now."""
    old, new = "", ""
    if kind == "contact":
        old, new = "gazebo_msgs/msg/ContactsState", "ros_gz_interfaces/msg/Contacts"
    elif plugin_as_written(plugin, element, library_of(attribute(plugin, "filename"))).is_range:
        old, new = "sensor_msgs/msg/Range", "sensor_msgs/msg/LaserScan"
    if new:
        message = f"sensor '{attribute(element, 'name')}' publishes {new}, not {old}: change who reads it"
        yield ReportEntry(EntryKind.FOR_YOU, message, element.at, authority="ros_gz_bridge README: types of messages")


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
