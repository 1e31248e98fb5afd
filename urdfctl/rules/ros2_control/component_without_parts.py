"""UC362."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_conditional
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC362",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "Importing state interfaces for the '
    "hardware 'arm' returned no state interfaces.\"",
    bad=[
        {
            "robot.urdf": """
                «<ros2_control name="arm" type="system">»
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
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
def component_without_parts(project: Project) -> Iterator[Finding]:
    """Component without joints, sensors and gpios.

    Nothing can be read from the component or commanded. Controllers do not find the interfaces that they request.
    """
    for control in components(project):
        if (
            control.parts
            or any(transmission.is_ros1 for transmission in control.transmissions)
            or not is_all_there(project, control.tag)
        ):
            continue
        severity = Severity.INFO if is_conditional(control.at) else Severity.WARNING
        message = f"{component(control)} has no <joint>, <sensor> or <gpio>, so it has no interfaces"
        yield Finding(control.at, message, severity=severity)
