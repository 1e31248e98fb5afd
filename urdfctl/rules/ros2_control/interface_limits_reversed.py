"""UC333."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label
from urdfctl.rules.ros2_control.common import called, interfaces, is_number


@rule(
    "UC333",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp accepts min and max as they are; the limiter "
    "then has an empty range",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    <command_interface name="position">
                      «<param name="min">»1</param>
                      <param name="max">-1</param>
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
def interface_limits_reversed(project: Project) -> Iterator[Finding]:
    """Lower limit of an interface is above the upper limit.

    The description loads, but no command is within the limits.
    """
    for part, interface in interfaces(project):
        lower, upper = interface.parameter("min"), interface.parameter("max")
        if lower is None or upper is None or not (is_number(lower.value) and is_number(upper.value)):
            continue
        if float(lower.value) > float(upper.value):
            of = f"{called(interface)} of {label(part.kind, part.name)}"
            yield Finding(lower.at, f"'min' of {of} is {lower.value}, which is greater than 'max' ({upper.value})")
