"""UC332."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, label
from urdfctl.rules.ros2_control.common import called, interfaces, is_number


@rule(
    "UC332",
    severity=Severity.WARNING,
    runtime="warns",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Error parsing the limits for the '
    "interface: position from the tags [min: 'low' and max: 'high'] within ros2_control tag inside the "
    'URDF. Skipping it"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      «<param name="min">»-90deg</param>
                      <param name="max">1</param>
                    </command_interface>
                    <state_interface name="position"/>
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
                    <command_interface name="position">
                      <param name="min">-1</param>
                      <param name="max">1</param>
                    </command_interface>
                    <state_interface name="position"/>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def interface_limit_malformed(project: Project) -> Iterator[Finding]:
    """Malformed limit of an interface.

    Since jazzy, both limits of the interface are skipped with a log message that is easy to miss. Earlier distros leave
    them to the hardware, and a simulator may fail.
    """
    for part, interface in interfaces(project):
        for name in ("min", "max"):
            parameter = interface.parameter(name)
            if parameter is None or not is_known(parameter.value) or is_number(parameter.value) or not parameter.value:
                continue
            what = f"'{name}' of {called(interface)} of {label(part.kind, part.name)}"
            yield Finding(
                parameter.at, f"{what} must be a finite number, not '{parameter.value}'; both limits are ignored"
            )
