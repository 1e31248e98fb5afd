"""UC323."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from urdfctl.model.robot import Tag
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, severity_where
from urdfctl.rules.ros2_control.common import (
    JAZZY,
    component,
    components,
    first_of,
    is_boolean,
    is_number,
    is_positive_integer,
)

_POLICIES = ("synchronized", "detached")


@rule(
    "UC323",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Error parsing async tag: String must be a'
    " flat array: starts with '[' and ends with ']', no nested arrays\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <properties><async affinity="«0,1»" thread_priority="40"/></properties>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <properties><async affinity="«[a]»" scheduling_policy="«fifo»" thread_priority="«high»" print_warnings="«1»"/></properties>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <properties>«<async affinity="[0]"/>»</properties>
                </ros2_control>
            """,
        },
    ],
    good=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <properties><async affinity="[0,1]" thread_priority="40" scheduling_policy="detached"/></properties>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system" is_async="true">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <properties><async scheduling_policy="synchronized" print_warnings="false"/></properties>
                </ros2_control>
            """,
        },
    ],
)
def async_properties_malformed(project: Project) -> Iterator[Finding]:
    """Invalid or unused `<async>` properties of a component.

    Since jazzy, the controller manager rejects the description or does not initialize the component. If the component
    is not asynchronous, the element is ignored.
    """
    for control in components(project):
        asynchronous = control.tag.attributes.get("is_async", "").strip().lower() == "true"
        for properties in control.tag.named("properties"):
            for tag in first_of(properties, "async"):
                if not asynchronous and is_known(control.tag.attributes.get("is_async")):
                    message = f'<async> of {component(control)} is ignored; it requires is_async="true"'
                    yield Finding(tag.at, message, severity=Severity.WARNING)
                    continue
                for attribute, expected in _malformed(tag):
                    text = tag.attributes[attribute]
                    message = f"'{attribute}' of <async> of {component(control)} must be {expected}, not '{text}'"
                    yield Finding(tag.at[attribute], message, severity=severity_where(project, JAZZY))


def _malformed(tag: Tag) -> Iterator[tuple[str, str]]:
    """The malformed attributes, each with the expected form."""
    forms: dict[str, tuple[Callable[[str], bool], str]] = {
        "affinity": (_is_array, "a list of cores such as '[0,1]'"),
        "scheduling_policy": (_is_policy, "'synchronized' or 'detached'"),
        "thread_priority": (is_positive_integer, "a positive integer"),
        "print_warnings": (is_boolean, "'true' or 'false'"),
    }
    for attribute, (is_valid, expected) in forms.items():
        text = tag.attributes.get(attribute)
        if text is not None and is_known(text) and not is_valid(text):
            yield attribute, expected


def _is_array(text: str) -> bool:
    return bool(re.fullmatch(r"\[[^\[\]]*\]", text.strip())) and all(
        is_number(part) for part in text.strip(" []").split(",")
    )


def _is_policy(text: str) -> bool:
    return text.strip().lower() in _POLICIES
