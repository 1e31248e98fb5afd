"""UC329."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import robot_in
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.source.opaque import UNKNOWN


@rule(
    "UC329",
    severity=Severity.ERROR,
    runtime="drops",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "no ros2_control tag"; it reads '
    "only the children of the root element",
    bad=[
        {
            "robot.urdf": """
                <gazebo>
                  «<ros2_control name="arm" type="system">»
                    <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                    <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  </ros2_control>
                </gazebo>
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
def ros2_control_not_in_root(project: Project) -> Iterator[Finding]:
    """`<ros2_control>` is not directly in `<robot>`.

    The parser does not see it, and its joints have no interfaces. If there is no other `<ros2_control>`, the
    description is rejected.
    """
    robot = robot_in(project)
    alone = not components(project)
    for control in robot.ros2_controls if robot else ():
        parent = control.parent
        if parent == "robot" or ":" in parent or parent == UNKNOWN:
            continue
        message = f"{component(control)} is ignored inside <{parent}>; it must be directly under <robot>"
        severity = Severity.ERROR if alone else Severity.WARNING
        yield Finding(control.at, message, fix=Fix("move it directly under <robot>"), severity=severity)
