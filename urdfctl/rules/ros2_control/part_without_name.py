"""UC307."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import component, parts


@rule(
    "UC307",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no attribute name in joint tag"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  «<joint>»<command_interface name="position"/><state_interface name="position"/></joint>
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
def part_without_name(project: Project) -> Iterator[Finding]:
    """Joint, sensor or gpio of a component without a name.

    The controller manager rejects the whole description.
    """
    for control, part in parts(project):
        if part.name is None:
            yield Finding(part.at, f"<{part.kind}> of {component(control)} has no 'name'")
        elif part.name == "" and part.kind != "joint":
            message = (
                f"<{part.kind}> of {component(control)} has an empty 'name'; no controller can request its interfaces"
            )
            yield Finding(part.at["name"], message, severity=Severity.WARNING)
