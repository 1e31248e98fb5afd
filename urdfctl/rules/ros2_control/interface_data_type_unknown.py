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
    "float": "float32",
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
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
              <gpio name="io"><state_interface name="count" data_type="«int»"/></gpio>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
              <gpio name="io"><state_interface name="count" data_type="int32"/></gpio>
            </ros2_control>
        """,
    },
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
