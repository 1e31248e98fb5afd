"""UC302."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC302",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no attribute type in ros2_control tag"',
    bad=[
        {
            "robot.urdf": """
                «<ros2_control name="arm">»
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
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
def component_without_type(project: Project) -> Iterator[Finding]:
    """`<ros2_control>` without a type.

    The controller manager rejects the whole description. A system drives several joints, an actuator drives one, and a
    sensor drives none.
    """
    for control in components(project):
        if control.type is None:
            message = f'{component(control)} has no \'type\'; add type="system", "actuator" or "sensor"'
            yield Finding(control.at, message)
