"""UC358."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, severity_where
from urdfctl.rules.ros2_control.common import JAZZY, called, known_hardware, parts
from urdfctl.rules.ros2_control.facts import DATA_TYPES, MOCK

_MIRRORED = ("position", "velocity", "acceleration", "effort")


@rule(
    "UC358",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=JAZZY,
    authority="measured with jazzy's mock_components/GenericSystem: \"Data type: 'int32' will not be casted to "
    'double for interface: elbow/position. Use get_optional<int32>() instead."',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position" data_type="«int32»"/>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position" data_type="«bool»"/>
                    <command_interface name="velocity" data_type="«int8»"/>
                    <command_interface name="acceleration" data_type="«uint8»"/>
                    <command_interface name="effort" data_type="«float32»"/>
                    <command_interface name="gripping" data_type="bool"/>
                    <state_interface name="position"/>
                    <state_interface name="velocity"/>
                    <state_interface name="acceleration"/>
                    <state_interface name="effort"/>
                    <state_interface name="gripping" data_type="bool"/>
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
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def command_of_other_data_type(project: Project) -> Iterator[Finding]:
    """Mirrored command interface of mock hardware is not of type double.

    Mock hardware copies this command to the joint's state. Since jazzy, it fails at the first read and is deactivated
    if the command is not of type `double`.
    """
    for control, part in parts(project, "joint"):
        if not any(each.type == MOCK for each in known_hardware(project, control)):
            continue
        states = {interface.name for interface in part.states}
        for interface in part.commands:
            kind = interface.tag.attributes.get("data_type", "double").strip()
            if kind in DATA_TYPES and kind != "double" and interface.name in states & set(_MIRRORED):
                of = f"{called(interface)} of {label('joint', part.name)}"
                message = f"{of} has data type '{kind}', but mock hardware requires 'double'"
                yield Finding(interface.at["data_type"], message, severity=severity_where(project, JAZZY))
