"""UC305."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_conditional
from urdfctl.rules.ros2_control.common import component, components


@rule(
    "UC305",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp leaves the class empty; pluginlib: "the '
    'class with base class type hardware_interface::SystemInterface does not exist"',
    bad=[
        {
            "robot.urdf": """
                «<ros2_control name="arm" type="system">»
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
def component_without_hardware(project: Project) -> Iterator[Finding]:
    """Component without `<hardware>`.

    Nothing names the class that drives the component, so it cannot be loaded. The controller manager then has no
    hardware at all. If conditions choose the hardware, the given arguments select none.
    """
    for control in components(project):
        if control.hardware or not is_all_there(project, control.tag):
            continue
        if is_conditional(control.at):
            message = f"{component(control)} has no <hardware> with these arguments"
            yield Finding(control.at, message, severity=Severity.INFO)
        else:
            yield Finding(
                control.at, f"{component(control)} has no <hardware>; add one whose <plugin> names the class to load"
            )
