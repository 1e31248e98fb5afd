"""UC339."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import Ros2Control, Tag
from urdfctl.names import nearest
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import attribute_respelt
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.rules.ros2_control.facts import ATTRIBUTES
from urdfctl.source.span import SourceSpan


@rule(
    "UC339",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: FindAttribute("...") by exact names; other'
    " attributes are silently ignored",
    bad=[
        {
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
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware type="«system»"><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_asnc="«true»" rwrate="«100»" thread_prioriti="«50»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint nam="«elbow»" name="elbow" mimick="«false»">
                    <command_interface name="position" datatype="«double»" siz="«1»" max="«1»"><param nme="«a»" name="min">-1</param></command_interface>
                    <state_interface name="position" initial_value="«0»"/>
                    <param name="frame" value="«fore»"/>
                  </joint>
                  <sensor nam="«tip»" name="tip"><state_interface name="force"/></sensor>
                  <gpio nam="«io»" name="io"><state_interface name="on" data_typ="«bool»"/></gpio>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="«true»" rw_rate="«100»" thread_priority="«50»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow" mimic="«false»">
                    <command_interface name="position" data_type="«double»" size="«1»"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
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
        {
            "options": "--distro=jazzy",
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true" rw_rate="100" thread_priority="50">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow" mimic="false">
                    <command_interface name="position" data_type="double" size="1"/>
                    <state_interface name="position"/>
                  </joint>
                  <gpio name="io"><state_interface name="on" data_type="bool" size="2"/></gpio>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <gpio name="io"><state_interface name="on" data_type="bool" size="2"/></gpio>
                </ros2_control>
            """,
        },
    ],
)
def attribute_not_read(project: Project) -> Iterator[Finding]:
    """Ignored attribute in a component.

    The parser ignores the attribute without a message. Some attributes are read only since a later distro: `is_async`
    since iron; `rw_rate`, `thread_priority`, `mimic` of a joint, and `data_type` and `size` of a joint's interfaces
    since jazzy.
    """
    for control in components(project):
        for tag, kind in _elements(control):
            for attribute in tag.attributes:
                readers = ATTRIBUTES[kind].get(attribute)
                if attribute.startswith("xmlns") or ":" in attribute or set(readers or ()) & set(project.distros):
                    continue
                message = f"attribute '{attribute}' of <{tag.name}> in {component(control)} is ignored"
                message += _instead(tag, attribute, kind) if readers is None else f" before {readers[0]}"
                fix = _fix(tag, attribute, kind) if readers is None else None
                yield Finding(tag.at[attribute], message, fix=fix)


def _elements(control: Ros2Control) -> Iterator[tuple[Tag, str]]:
    """The elements whose attributes the parser reads by name, each with its key in ATTRIBUTES."""
    yield control.tag, "ros2_control"
    for hardware in control.hardware:
        yield hardware.tag, "hardware"
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
        return f'; write <param name="{attribute}">{value}</param> inside <{tag.name}>'
    meant = _meant(tag, attribute, kind)
    return f"; did you mean '{meant}'?" if meant else ""


def _meant(tag: Tag, attribute: str, kind: str) -> str | None:
    return nearest(attribute, (name for name in ATTRIBUTES[kind] if name not in tag.attributes))


def _fix(tag: Tag, attribute: str, kind: str) -> Fix | None:
    """Respell the attribute, or move a value into its empty <param>: such a value can only mean that."""
    if kind != "param" or attribute != "value":
        return attribute_respelt(tag, attribute, _meant(tag, attribute, kind))
    start, source = tag.at.source.start_tag(tag.at.start), tag.at.source
    if start is None or not start.self_closed:
        return None
    value = tag.at["value"].span
    prefix = re.search(rb"\s+value\s*=\s*[\"']\Z", source.data[tag.at.start : value.start])
    if prefix is None:
        return None
    edits = (
        Edit(SourceSpan(source, tag.at.start + prefix.start(), value.end + 1), ""),
        Edit(SourceSpan(source, start.end - len("/>"), start.end), f">{value.text}</param>"),
    )
    return Fix("move the value between <param> and </param>", edits, safe=True)
