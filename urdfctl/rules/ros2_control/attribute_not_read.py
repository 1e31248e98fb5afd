"""UC339."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.parts import Tag
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import attribute_respelt
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.rules.ros2_control.facts import ATTRIBUTES
from urdfctl.source.span import SourceSpan
from urdfctl.suggest import nearest


@rule(
    "UC339",
    severity=Severity.WARNING,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: FindAttribute("...") by exact names; other'
    " attributes are passed over without a word",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position" min="«-1»"/>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position"><param name="min">-1</param></command_interface>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
)
def attribute_not_read(project: Project) -> Iterator[Finding]:
    """An attribute in a component is not read.

    Nobody tells of it. Some are read from a later distro on: is_async from iron, rw_rate and thread_priority, mimic
    of a joint, data type and size of a joint's interfaces from jazzy.
    """
    for control in components(project):
        for tag, kind in _read(control):
            for attribute in tag.attributes:
                since_then = ATTRIBUTES[kind].get(attribute)
                if attribute.startswith("xmlns") or ":" in attribute or set(since_then or ()) & set(project.distros):
                    continue
                message = f"'{attribute}' of <{tag.name}> in {component(control)} is not read"
                message += _instead(tag, attribute, kind) if since_then is None else f" before {since_then[0]}"
                fix = _fix(tag, attribute, kind) if since_then is None else None
                yield Finding(tag.at[attribute], message, fix=fix)


def _read(control: Ros2Control) -> Iterator[tuple[Tag, str]]:
    """The elements whose attributes are looked for by name, each with what it is."""
    yield control.tag, "ros2_control"
    for hardware in control.hardware:
        yield from ((parameter.tag, "param") for parameter in hardware.parameters)
    for part in control.parts:
        yield part.tag, part.kind
        yield from ((parameter.tag, "param") for parameter in part.parameters)
        for interface in part.interfaces:
            yield interface.tag, "gpio interface" if part.kind == "gpio" else "interface"
            yield from ((parameter.tag, "param") for parameter in interface.parameters)


def _instead(tag: Tag, attribute: str, kind: str) -> str:
    value = tag.attributes[attribute]
    if kind == "param" and attribute == "value":
        return f'; write <param name="{tag.attributes.get("name", "")}">{value}</param>'
    if attribute in ("min", "max", "initial_value") and kind.endswith("interface"):
        return f'; write <param name="{attribute}">{value}</param> in it'
    meant = _meant(tag, attribute, kind)
    return f"; did you mean '{meant}'?" if meant else ""


def _meant(tag: Tag, attribute: str, kind: str) -> str | None:
    return nearest(attribute, (name for name in ATTRIBUTES[kind] if name not in tag.attributes))


def _fix(tag: Tag, attribute: str, kind: str) -> Fix | None:
    """The value of a parameter stands in it; where it stands in an attribute of an empty one it is surely meant so."""
    if kind != "param" or attribute != "value":
        return attribute_respelt(tag, attribute, _meant(tag, attribute, kind))
    start, source = tag.at.source.start_tag(tag.at.start), tag.at.source
    if start is None or not start.self_closed:
        return None
    value = tag.at["value"].span
    written = re.search(rb"\s+value\s*=\s*[\"']\Z", source.data[tag.at.start : value.start])
    if written is None:
        return None
    edits = (
        Edit(SourceSpan(source, tag.at.start + written.start(), value.end + 1), ""),
        Edit(SourceSpan(source, start.end - len("/>"), start.end), f">{value.text}</param>"),
    )
    return Fix("write the value between <param> and </param>", edits, safe=True)
