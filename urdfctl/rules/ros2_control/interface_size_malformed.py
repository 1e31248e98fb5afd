"""UC319."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, called, interfaces


@rule(
    "UC319",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp: 'Could not parse size tag in "
    '"command_interface". Got "0", but expected a non-zero positive integer.\'',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <gpio name="io"><state_interface name="inputs" size="«0»"/></gpio>
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
def interface_size_malformed(project: Project) -> Iterator[Finding]:
    """Interface size is not a positive integer.

    The controller manager rejects the description. Up to iron, only interfaces of a gpio have a size.
    """
    for part, interface in interfaces(project):
        size = interface.tag.attributes.get("size")
        if size is None or not is_known(size) or _is_size(size):
            continue
        rejecting = ROS2 if part.kind == "gpio" else JAZZY
        if set(rejecting) & set(project.distros):
            message = (
                f"size of {called(interface)} of {label(part.kind, part.name)} must be a positive integer, not '{size}'"
            )
            yield Finding(interface.at["size"], message, severity=severity_where(project, rejecting))


def _is_size(text: str) -> bool:
    digits = re.fullmatch(r"[1-9][0-9]{0,9}", text.strip())
    return digits is not None and int(digits.group()) < 2**31
