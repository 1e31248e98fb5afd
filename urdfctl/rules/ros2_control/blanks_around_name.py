"""UC351."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2, since
from urdfctl.diagnostic import Edit
from urdfctl.model.robot import ElementText, Ros2Control, Tag
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced, severity_where
from urdfctl.rules.ros2_control.common import OLD, components
from urdfctl.source.span import SourceSpan


@rule(
    "UC351",
    severity=Severity.WARNING,
    runtime="refuses",
    because="newer releases strip the blanks",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp trims names since jazzy 4.43, kilted 5.12 "
    "and rolling 6.4, but not before; topic_based_hardware_interfaces#1: a formatter wrapped the lines of <plugin>",
    options=["--distro=humble"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    «<plugin>»
                      mock_components/GenericSystem
                    </plugin>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
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
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def blanks_around_name(project: Project) -> Iterator[Finding]:
    """Whitespace around a name in a component.

    Up to iron, and in jazzy and kilted releases before 2026, the whitespace is part of the name. No plugin, joint or
    interface has that name, and the description or the controller is rejected. Newer releases strip it.
    """
    if not set(project.distros) - set(since("lyrical")):
        return
    for control in components(project):
        for hardware in control.hardware[-1:]:
            for plugin in hardware.plugins[:1]:
                if plugin.padded and is_known(plugin.value):
                    message = f"<plugin> has whitespace around '{plugin.past_comments}', which becomes part of the name"
                    yield Finding(plugin.at, message, fix=_bare(plugin), severity=severity_where(project, OLD))
        for tag in _named(control):
            for attribute in ("name", "type") if tag.name == "ros2_control" else ("name",):
                text = tag.attributes.get(attribute, "")
                if text != text.strip() and text.strip() and is_known(text):
                    fix = replaced(tag.at[attribute], text, text.strip(), safe=True)
                    message = (
                        f"'{attribute}' of <{tag.name}> has whitespace around '{text.strip()}', "
                        "which becomes part of the name"
                    )
                    yield Finding(tag.at[attribute], message, fix=fix)


def _bare(plugin: ElementText) -> Fix:
    tag = plugin.at.span
    closing = plugin.at.closing
    if closing is None or plugin.at.content.span.text != plugin.value:
        return Fix(f"write <plugin>{plugin.past_comments}</plugin>")
    edit = Edit(SourceSpan(tag.source, tag.end, closing), plugin.value)
    return Fix(f"write <plugin>{plugin.value}</plugin>", (edit,), safe=True)


def _named(control: Ros2Control) -> Iterator[Tag]:
    """The elements of a component that have a name."""
    yield control.tag
    for part in control.parts:
        yield part.tag
        yield from (interface.tag for interface in part.interfaces)
    for transmission in control.transmissions:
        yield from (end.tag for end in (*transmission.joints, *transmission.actuators))
