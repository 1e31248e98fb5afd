"""Plugins of ROS 1 that are a sensor themselves, outside of any <sensor>, become sensors of gz."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.diagnostic import Edit
from urdfctl.migrate.classic.choice import CHOICE, is_chosen, keeps_classic, replaced
from urdfctl.migrate.classic.systems import in_namespace, library_of, plain_frame
from urdfctl.migrate.edits.markup import (
    attribute,
    child,
    content,
    end_of,
    indent_of,
    indented,
    is_zero,
    parent_of,
    removal,
    step_of,
)
from urdfctl.migrate.edits.places import plugin_elements
from urdfctl.migrate.options import Part
from urdfctl.migrate.packages import MigratedPackages
from urdfctl.migrate.shared.hardware import goes_to_gz
from urdfctl.migrate.step import EntryKind, Proposal, ReportEntry, Row, Step
from urdfctl.migrate.todo import for_you
from urdfctl.source.span import SourceSpan
from urdfctl.source.xml.dom import Element

_AUTHORITY = "hector_gazebo_plugins, gazebo_plugins (ROS 1): <bodyName>, <topicName>, <updateRate>; gz-sensors"
LOOSE: Mapping[str, tuple[str, str]] = {
    "hector_gazebo_ros_imu": ("imu", "imu"),
    "gazebo_ros_imu": ("imu", "imu"),
    "hector_gazebo_ros_gps": ("navsat", "fix"),
}
"""By library of Gazebo Classic: the type of the sensor in gz, and its topic if none is set."""
_FRAMES = ("frameId", "frameName", "frame_id")
_RATES = ("updateRate", "updateRateHZ")
_READ = (*_FRAMES, *_RATES, "bodyName", "topicName", "robotNamespace", "alwaysOn", "always_on")
_IN_CLASSIC = {"imu": ("imu", "gazebo_ros_imu_sensor"), "navsat": ("gps", "gazebo_ros_gps_sensor")}
"""By type of the sensor in gz: the type in Gazebo Classic, and the library that publishes it in ROS 2."""


def _loose_sensors(packages: MigratedPackages) -> Iterator[Proposal]:
    to_gz = goes_to_gz(packages)
    if not to_gz and not (packages.is_ros1 and packages.simulator == "gazebo-classic"):
        return
    for element in plugin_elements(packages):
        library = library_of(attribute(element, "filename"))
        around = parent_of(element)
        body = child(element, "bodyName")
        if library not in LOOSE or around is None or around.tagName != "gazebo" or is_chosen(element):
            continue
        link = content(body) if body is not None else attribute(around, "reference")
        if not link:
            yield for_you(
                element.at, f"plugin '{library}' names no link: write its sensor below one", authority=_AUTHORITY
            )
            continue
        kind = LOOSE[library][0] if to_gz else _IN_CLASSIC[LOOSE[library][0]][0]
        message = f"plugin '{library}' became a sensor of type {kind} on link '{link}'"
        entries = [ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY)]
        others = (one for one in element.elements() if one.tagName not in _READ and ":" not in one.tagName)
        if dropped := [one.tagName for one in others if not is_zero(one)]:
            message = f"the sensor has no {', '.join(dropped)} of '{library}': dropped"
            entries.append(ReportEntry(EntryKind.DONE, message, element.at, authority=_AUTHORITY))
        text = _sensor(element, library, link, to_gz=to_gz)
        is_alone = len(around.elements()) == 1
        edits = replaced(packages, around, text) if is_alone else _moved(packages, element, around, text)
        yield Proposal(tuple(edits), entries=tuple(entries))


def _moved(packages: MigratedPackages, plugin: Element, around: Element, text: str) -> Iterator[Edit]:
    """The edits that write a sensor after the element with its plugin, in which other plugins stay."""
    if keeps_classic(packages, plugin):
        yield from replaced(packages, plugin, "")
        unless = f'<xacro:unless value="$(arg {CHOICE})">'
        text = f"{unless}\n{indented(text, step_of(plugin.source))}</xacro:unless>\n"
    else:
        yield removal(plugin)
    end = end_of(around)
    yield Edit(SourceSpan(around.source, end, end), f"\n{indented(text, indent_of(around))}".rstrip("\n"))


def _sensor(plugin: Element, library: str, link: str, *, to_gz: bool) -> str:
    kind, default = LOOSE[library]
    step, name = step_of(plugin.source), attribute(plugin, "name")
    topic = _given(plugin, ("topicName",), default)
    rate = _given(plugin, _RATES, "50")
    frame = plain_frame(_given(plugin, _FRAMES, link))
    lines = [f"<update_rate>{rate}</update_rate>", "<always_on>true</always_on>"]
    if to_gz:
        topic = in_namespace(plugin, topic).lstrip("/")
        lines += [f"<topic>{topic}</topic>", f"<gz_frame_id>{frame}</gz_frame_id>"]
    else:
        kind, successor = _IN_CLASSIC[kind]
        lines += [f'<plugin name="{name}" filename="lib{successor}.so">', *_of_plugin(plugin, topic, frame, step)]
    inside = "".join(f"{step * 2}{line}\n" for line in lines)
    head = f'<gazebo reference="{link}">\n{step}<sensor name="{name}" type="{kind}">\n'
    return f"{head}{inside}{step}</sensor>\n</gazebo>\n"


def _of_plugin(plugin: Element, topic: str, frame: str, step: str) -> Iterator[str]:
    """The lines of a plugin of ROS 2 that publishes a sensor, after its first one."""
    space = child(plugin, "robotNamespace")
    yield f"{step}<ros>"
    if space is not None and content(space).strip("/"):
        yield f"{step * 2}<namespace>{content(space)}</namespace>"
    yield f"{step * 2}<remapping>~/out:={topic}</remapping>"
    yield from (f"{step}</ros>", f"{step}<frame_name>{frame}</frame_name>", "</plugin>")


def _given(plugin: Element, names: Sequence[str], default: str) -> str:
    """The value of the first of some settings that a plugin has."""
    return next((content(one) for name in names if (one := child(plugin, name)) is not None and content(one)), default)


LOOSE_SENSORS = Step(
    name="classic-loose-sensors",
    part=Part.URDF,
    summary="Plugins that are a sensor themselves",
    propose=_loose_sensors,
    rows=tuple(
        Row(f"lib{name}.so", f'<sensor type="{kind}">', "jazzy", _AUTHORITY) for name, (kind, _) in LOOSE.items()
    ),
    before=[
        {
            "options": "--to=jazzy --simulator=gz",
            "robot.urdf": """
                <gazebo>
                  <plugin name="imu" filename="libgazebo_ros_imu.so">
                    <bodyName>fore</bodyName>
                    <topicName>imu</topicName>
                    <updateRate>50</updateRate>
                  </plugin>
                </gazebo>
            """,
        },
    ],
    after=[
        {
            "robot.urdf": """
                <gazebo reference="fore">
                  <sensor name="imu" type="imu">
                    <update_rate>50</update_rate>
                    <always_on>true</always_on>
                    <topic>imu</topic>
                    <gz_frame_id>fore</gz_frame_id>
                  </sensor>
                </gazebo>
            """,
        },
    ],
)
