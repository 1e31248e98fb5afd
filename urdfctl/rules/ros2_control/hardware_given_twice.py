"""UC344."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.ros2_control.common import component, components, side_by_side


@rule(
    "UC344",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp reads the first <plugin>, and replaces an "
    "earlier <hardware> with a later one",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>arm_drivers/Arm</plugin>
                    «<plugin>»mock_components/GenericSystem</plugin>
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
def hardware_given_twice(project: Project) -> Iterator[Finding]:
    """Component with two plugins or two `<hardware>` elements.

    Of two plugins the first is loaded; of two `<hardware>` elements the last is used. The other one has no effect.
    """
    for control in components(project):
        for before, hardware in zip(control.hardware, control.hardware[1:], strict=False):
            if side_by_side(project, before.at, hardware.at):
                message = f"{component(control)} has a second <hardware>, which replaces the first"
                yield Finding(hardware.at, message, (Note("this <hardware> is ignored", before.at),))
        for hardware in control.hardware:
            for first, plugin in zip(hardware.plugins, hardware.plugins[1:], strict=False):
                if side_by_side(project, first.at, plugin.at):
                    message = f"plugin '{plugin.past_comments}' is not loaded; '{first.past_comments}' comes first"
                    yield Finding(plugin.at, message, (Note("this plugin is loaded", first.at),))
