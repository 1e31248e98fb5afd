"""Plugins for Gazebo Classic in the form of ROS 2: other libraries, names in snake case, and remapped topics."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.choice import is_chosen
from urdfctl.migrate.classic.sdf import OF_SDF
from urdfctl.migrate.classic.systems import comments_above, library_of
from urdfctl.migrate.edits.markup import (
    attribute,
    child,
    content,
    indent_of,
    indented,
    is_zero,
    parent_of,
    span_of,
    step_of,
)
from urdfctl.migrate.edits.places import plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.ros1.classic_settings import OF_SENSOR, SUCCESSORS, Successor, snake_case
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.source.xml.dom import Element

_AUTHORITY = "gazebo_plugins (ros2 branch): the header files of the plugins"
_SILENT = ("robotNamespace", "alwaysOn", "always_on", "legacyMode", "rosDebugLevel", "legacyModeNS", "serviceName")
"""Settings that ROS 2 needs not, or has in another place."""
_OF_ROS2 = ("ros", *(name for one in SUCCESSORS.values() for names in one.settings.values() for name in names))


def _plugins(packages: MigratedPackages) -> Iterator[Proposal]:
    if packages.simulator != "gazebo-classic":
        return
    for element in plugin_elements(packages, *OF_SDF):
        successor = SUCCESSORS.get(library_of(attribute(element, "filename")))
        if successor is not None and not is_chosen(element) and _is_of_ros1(element):
            yield _migrated(element, successor)


def _is_of_ros1(element: Element) -> bool:
    """Whether a plugin has a setting that only ROS 1 reads, or a library that only ROS 1 has."""
    library = library_of(attribute(element, "filename"))
    successor = SUCCESSORS[library]
    names = {one.tagName for one in element.elements()}
    old = {*successor.settings, *successor.topics, *_SILENT, *OF_SENSOR} - {*_OF_ROS2}
    return successor.library != library or bool(names & old)


def _migrated(element: Element, successor: Successor) -> Proposal:
    library = library_of(attribute(element, "filename"))
    around = parent_of(element)
    step, indent = step_of(element.source), indent_of(element)
    lines = [*_topics(element, successor, step), *_settings(element, successor)]
    head = f'<plugin name="{attribute(element, "name")}" filename="lib{successor.library}.so">'
    text = "\n".join([head, *(f"{step}{line}" for line in lines), "</plugin>"])
    new = indented(text, indent).lstrip()
    rate = next((one for one in element.elements() if one.tagName in OF_SENSOR and content(one)), None)
    if around is not None and around.tagName == "sensor" and rate is not None and child(around, "update_rate") is None:
        new = f"<update_rate>{content(rate)}</update_rate>\n{indent}{new}"
    message = f"plugin '{library}' became '{successor.library}' of ROS 2"
    entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)]
    dropped = [one.tagName for one in element.elements() if _is_dropped(one, element, successor)]
    if dropped:
        message = f"plugin '{successor.library}' does not read {', '.join(dropped)} in ROS 2: dropped"
        entries.append(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY))
    return Proposal((Edit(span_of(element), new),), entries=tuple(entries))


def _is_dropped(setting: Element, plugin: Element, successor: Successor) -> bool:
    around = parent_of(plugin)
    in_sensor = around is not None and around.tagName == "sensor"
    return not (
        setting.tagName in (*successor.settings, *successor.topics, *_SILENT, *_OF_ROS2)
        or (in_sensor and setting.tagName in OF_SENSOR)
        or is_zero(setting)
    )


def _topics(element: Element, successor: Successor, step: str) -> Iterator[str]:
    """The lines of `<ros>`: the namespace, and topics with other names than those of ROS 2."""
    space = child(element, "robotNamespace")
    camera = child(element, "cameraName")
    prefix = f"{content(camera)}/" if successor.camera and camera is not None else ""
    lines = []
    if space is not None and content(space).strip("/"):
        lines.append(f"{step}<namespace>{content(space)}</namespace>")
    for setting, topic in successor.topics.items():
        given = child(element, setting)
        new = content(given) if given is not None else ""
        if not new or new == topic:
            continue
        new = new if new.startswith(("/", "$")) else f"{prefix}{new}"
        lines.append(f"{step}<remapping>{prefix}{topic}:={new}</remapping>")
    if lines:
        yield from ("<ros>", *dict.fromkeys(lines), "</ros>")


def _settings(element: Element, successor: Successor) -> Iterator[str]:
    """The lines of the other settings, in their order."""
    written: set[str] = set()
    lines: list[str] = []
    for one in element.elements():
        value = content(one)
        names = successor.settings.get(one.tagName, (one.tagName,) if one.tagName in _OF_ROS2 else ())
        lines += comments_above(one) if names else []
        for name in names if one.tagName != "ros" else ():
            written.add(name)
            values = re.split(r"[\s,]+", value) if name in successor.lists else [value]
            lines += (f"<{name}>{successor.values.get(name, {}).get(each, each)}</{name}>" for each in values)
    added = [f"<{name}>{value}</{name}>" for name, value in successor.added if name not in written]
    yield from (*added, *lines)


PLUGINS = Step(
    name="classic-plugins-of-ros-1",
    part=Part.URDF,
    summary="Plugins for Gazebo Classic",
    propose=_plugins,
    generation=1,
    rows=(
        *(
            Row(f"lib{old}.so", f"lib{new.library}.so", "", _AUTHORITY)
            for old, new in SUCCESSORS.items()
            if old != new.library
        ),
        *(
            Row(f"lib{old}.so: {setting}", f"<ros><remapping>{topic}:=NAME", "", _AUTHORITY)
            for old, new in SUCCESSORS.items()
            if old == new.library
            for setting, topic in new.topics.items()
        ),
        Row("settings in camelCase", f"in snake_case: {snake_case('wheelSeparation')}", "", _AUTHORITY),
    ),
    before=[
        {
            "options": "--from=noetic --to=humble --simulator=gazebo-classic",
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="laser" type="ray">
                    <plugin name="laser" filename="libgazebo_ros_laser.so">
                      <topicName>scan</topicName>
                      <frameName>fore</frameName>
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
)
