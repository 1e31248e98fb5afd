"""UC331."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, called, interfaces, is_boolean, is_number
from urdfctl.rules.ros2_control.facts import DATA_TYPES


@rule(
    "UC331",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/include/hardware_interface/handle.hpp: "Invalid initial value : '
    "'90deg' parsed for interface : 'elbow/position' with type : 'double'\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position"/>
                    <state_interface name="position">
                      «<param name="initial_value">»90deg</param>
                    </state_interface>
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
                    <command_interface name="position"/>
                    <state_interface name="position">
                      <param name="initial_value">0.5</param>
                    </state_interface>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def initial_value_malformed(project: Project) -> Iterator[Finding]:
    """Initial value does not match the type of its interface.

    Since jazzy, the interface is not exported and the description is rejected. A number must be finite, with nothing
    after it; a bool must be true or false. Earlier distros leave the value to the hardware, which fails or reads only
    the leading digits.
    """
    for part, interface in interfaces(project):
        parameter = interface.parameter("initial_value")
        kind = interface.tag.attributes.get("data_type", "double").strip()
        if parameter is None or not parameter.value or not is_known(parameter.value, kind) or kind not in DATA_TYPES:
            continue
        if not _is_of(kind, parameter.value):
            of = f"{called(interface)} of {label(part.kind, part.name)}"
            message = f"initial value of {of} is '{parameter.value}'; {_expected(kind, parameter.value)}"
            yield Finding(parameter.at, message, severity=severity_where(project, JAZZY))


def _is_of(kind: str, text: str) -> bool:
    if kind == "bool":
        return is_boolean(text)
    return is_number(text) if kind in ("double", "float32") else bool(re.fullmatch(r"[+-]?[0-9]+", text))


def _expected(kind: str, text: str) -> str:
    if kind == "bool":
        return "expected 'true' or 'false'"
    if "${" in text or "$(" in text:
        return "expected a number. Expressions are not expanded here"
    return "expected a number in rad or m, without a unit"
