"""Plugins of ROS 1 that are a sensor themselves, outside of any <sensor>, become sensors of gz."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfctl.migrate.classic.choice import is_chosen, replaced
from urdfctl.migrate.classic.plugins import goes_to_gz
from urdfctl.migrate.classic.systems import library_of
from urdfctl.migrate.markup import attribute, child, content, parent_of, step_of
from urdfctl.migrate.packages import Packages
from urdfctl.migrate.ros1.simulator_plugin import plugin_elements
from urdfctl.migrate.step import Entry, EntryKind, Proposal, Row, Step
from urdfctl.migrate.wishes import Part
from urdfctl.source.dom import Element

_AUTHORITY = "hector_gazebo_plugins, gazebo_plugins (ROS 1): <bodyName>, <topicName>, <updateRate>; gz-sensors"
LOOSE: Mapping[str, tuple[str, str]] = {
    "hector_gazebo_ros_imu": ("imu", "imu"),
    "gazebo_ros_imu": ("imu", "imu"),
    "hector_gazebo_ros_gps": ("navsat", "fix"),
}
"""By library of Gazebo Classic: the type of the sensor in gz, and its topic if none is set."""


def _loose_sensors(packages: Packages) -> Iterator[Proposal]:
    if not goes_to_gz(packages):
        return
    for element in plugin_elements(packages):
        library = library_of(attribute(element, "filename"))
        around = parent_of(element)
        body = child(element, "bodyName")
        if library not in LOOSE or around is None or around.tagName != "gazebo" or is_chosen(element):
            continue
        link = content(body) if body is not None else attribute(around, "reference")
        if link and len(around.elements()) == 1:
            message = f"plugin '{library}' became a sensor of type {LOOSE[library][0]} on link '{link}'"
            entry = Entry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)
            yield Proposal(tuple(replaced(packages, around, _sensor(element, library, link))), entries=(entry,))


def _sensor(plugin: Element, library: str, link: str) -> str:
    kind, default = LOOSE[library]
    step = step_of(plugin.source)
    settings = {
        "topic": (("topicName",), default),
        "update_rate": (("updateRate", "updateRateHZ"), "50"),
        "gz_frame_id": (("frameId", "frameName", "frame_id"), link),
    }
    lines = [f'<gazebo reference="{link}">', f'{step}<sensor name="{attribute(plugin, "name")}" type="{kind}">']
    for name, (olds, value) in settings.items():
        given = next((content(one) for old in olds if (one := child(plugin, old)) is not None and content(one)), value)
        lines.append(f"{step * 2}<{name}>{given}</{name}>")
    return "\n".join([*lines, f"{step * 2}<always_on>true</always_on>", f"{step}</sensor>", "</gazebo>\n"])


LOOSE_SENSORS = Step(
    name="classic-loose-sensors",
    part=Part.URDF,
    summary="Plugins that are a sensor themselves",
    propose=_loose_sensors,
    rows=tuple(
        Row(f"lib{name}.so", f'<sensor type="{kind}">', "jazzy", _AUTHORITY) for name, (kind, _) in LOOSE.items()
    ),
)
