"""UC301."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import components


@rule(
    "UC301",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no attribute name in ros2_control tag"',
    bad=[
        {
            "robot.urdf": """
                «<ros2_control type="system">»
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
def component_without_name(project: Project) -> Iterator[Finding]:
    """`<ros2_control>` without a name.

    The controller manager rejects the whole description. The name identifies the hardware component, for example in the
    output of `ros2 control list_hardware_components`.
    """
    for control in components(project):
        if control.name is None:
            yield Finding(control.at, "<ros2_control> has no 'name'; give it a unique one")
