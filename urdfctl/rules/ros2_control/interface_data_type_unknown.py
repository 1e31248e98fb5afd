"""UC320."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known, label, replaced, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, called, interfaces
from urdfctl.rules.ros2_control.facts import DATA_TYPES

_MEANT = {
    "int": "int32",
    "uint": "uint32",
    "integer": "int32",
    "float64": "double",
    "boolean": "bool",
}


@rule(
    "UC320",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority='ros2_control hardware_interface/include/hardware_interface/hardware_info.hpp: "Invalid data type: '
    "'int' for interface: io/out. Check supported types.\"",
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <gpio name="io"><state_interface name="count" data_type="«int»"/></gpio>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <gpio name="io">
                    <state_interface name="a" data_type="«uint»"/>
                    <state_interface name="b" data_type="«integer»"/>
                    <state_interface name="c" data_type="«float»"/>
                    <state_interface name="d" data_type="«float64»"/>
                    <state_interface name="e" data_type="«Boolean»"/>
                    <state_interface name="f" data_type="«string»"/>
                    <state_interface name="g" data_type="«INT16»"/>
                    <state_interface name="h" data_type="«uint_32»"/>
                  </gpio>
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
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  <gpio name="io"><state_interface name="count" data_type="int32"/></gpio>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <gpio name="io">
                    <state_interface name="double" data_type="double"/>
                    <state_interface name="bool" data_type="bool"/>
                    <state_interface name="float32" data_type="float32"/>
                    <state_interface name="uint8" data_type="uint8"/>
                    <state_interface name="int8" data_type="int8"/>
                    <state_interface name="uint16" data_type="uint16"/>
                    <state_interface name="int16" data_type="int16"/>
                    <state_interface name="uint32" data_type="uint32"/>
                    <state_interface name="int32" data_type="int32"/>
                  </gpio>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_data_type_unknown(project: Project) -> Iterator[Finding]:
    """Unknown data type of an interface.

    Since jazzy, the interface is not exported and the description is rejected. Earlier distros read only the data type
    of a gpio and leave it to the hardware.
    """
    for part, interface in interfaces(project):
        kind = interface.tag.attributes.get("data_type")
        if kind is None or not is_known(kind) or kind.strip() in DATA_TYPES:
            continue
        lowered = kind.strip().lower()
        meant = _MEANT.get(lowered) or (lowered if lowered in DATA_TYPES else nearest(lowered, DATA_TYPES))
        hint = f"did you mean '{meant}'?" if meant else f"known types are {in_words(DATA_TYPES, len(DATA_TYPES))}"
        at = interface.at["data_type"]
        fix = replaced(at, kind, meant) if meant else None
        message = f"{called(interface)} of {label(part.kind, part.name)} has unknown data type '{kind}'; {hint}"
        yield Finding(at, message, fix=fix, severity=severity_where(project, JAZZY))
