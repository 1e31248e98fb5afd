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
    distros=ROS2,
    authority='ros2_control hardware_interface/include/hardware_interface/handle.hpp: "Invalid initial value : '
    "'90deg' parsed for interface : 'elbow/position' with type : 'double'\"",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def initial_value_malformed(project: Project) -> Iterator[Finding]:
    """An initial value is not one of its interface's type.

    From jazzy on the interface is not exported, and the description refused: a number is finite and has nothing
    behind it, a bool is true or false. Before, it is left to the hardware, which stops at it or reads the digits in
    front.
    """
    for part, interface in interfaces(project):
        parameter = interface.parameter("initial_value")
        kind = interface.tag.attributes.get("data_type", "double").strip()
        if parameter is None or not parameter.value or not is_known(parameter.value, kind) or kind not in DATA_TYPES:
            continue
        if not _is_of(kind, parameter.value):
            right = "'true' or 'false'" if kind == "bool" else f"a number{_hint(parameter.value)}"
            of = f"{called(interface)} of {label(part.kind, part.name)}"
            message = f"the initial value of {of} is '{parameter.value}'; it is {right}"
            yield Finding(parameter.at, message, severity=severity_where(project, JAZZY))


def _is_of(kind: str, text: str) -> bool:
    if kind == "bool":
        return is_boolean(text)
    return is_number(text) if kind in ("double", "float32") else bool(re.fullmatch(r"[+-]?[0-9]+", text))


def _hint(text: str) -> str:
    if "${" in text or "$(" in text:
        return ", and nothing expands an expression here"
    return ", in rad or m, without a unit behind it"
