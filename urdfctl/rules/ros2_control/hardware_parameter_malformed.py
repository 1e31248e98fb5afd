"""UC357."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.catalog.hardware import HardwareType
from urdfctl.model.robot import HardwareParameter
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, components, is_boolean, is_number, known_hardware

_EXPECTED = {"bool": "'true' or 'false'", "double": "a number"}


@rule(
    "UC357",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/lexical_casts.cpp: \"Input string : 'yes' is not a valid boolean "
    "value. Expected 'true' or 'false'.\", \"Failed converting string to real number\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<param name="calculate_dynamics">»yes</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<param name="position_state_following_offset">»much</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "options": "--distro=humble",
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<param name="calculate_dynamics">»yes</param>
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
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    <param name="calculate_dynamics">true</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def hardware_parameter_malformed(project: Project) -> Iterator[Finding]:
    """Hardware parameter has a value of the wrong type.

    Since jazzy, mock hardware is not initialized with it, and the description is rejected. Earlier distros and other
    hardware treat everything except `true` as false.
    """
    for control in components(project):
        hardware = known_hardware(project, control)
        for parameter in control.hardware[-1].parameters if hardware else ():
            types = {
                (each.hardware_parameters or {})[parameter.name or ""].type
                for each in hardware
                if _knows(each, parameter)
            }
            kind = types.pop() if len(types) == 1 else ""
            expected, is_valid = _EXPECTED.get(kind), is_boolean if kind == "bool" else is_number
            if expected and is_known(parameter.value) and not is_valid(parameter.value):
                message = (
                    f"parameter '{parameter.name}' of '{hardware[0].type}' must be {expected}, not '{parameter.value}'"
                )
                is_mock = hardware[0].simulator == "mock"
                severity = severity_where(project, JAZZY) if is_mock else Severity.WARNING
                yield Finding(parameter.at, message, severity=severity)


def _knows(hardware: HardwareType, parameter: HardwareParameter) -> bool:
    return parameter.name in (hardware.hardware_parameters or ())
