"""UC309."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import parameters


@rule(
    "UC309",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no parameter name attribute set in param '
    'tag"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    «<param>»true</param>
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
def parameter_without_name(project: Project) -> Iterator[Finding]:
    """`<param>` of a component without a name.

    The controller manager rejects the whole description.
    """
    for of, given in parameters(project):
        for parameter in given:
            if parameter.name is None:
                value = f" (its value is '{parameter.value}')" if parameter.value else ""
                yield Finding(parameter.at, f"<param> of {of} has no 'name'{value}")
