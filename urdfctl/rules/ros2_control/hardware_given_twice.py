"""UC344."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.ros2_control.common import component, components, side_by_side


@rule(
    "UC344",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp reads the first <plugin>, and lets a later "
    "<hardware> take the place of an earlier one",
    bad={
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
    good={
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
)
def hardware_given_twice(project: Project) -> Iterator[Finding]:
    """A component has two plugins, or two `<hardware>`.

    Of two plugins the first is loaded, of two `<hardware>` the last counts: the other says nothing.
    """
    for control in components(project):
        for before, hardware in zip(control.hardware, control.hardware[1:], strict=False):
            if side_by_side(project, before.at, hardware.at):
                message = f"{component(control)} has a second <hardware>, which takes the place of the first"
                yield Finding(hardware.at, message, (Note("this one counts for nothing", before.at),))
        for hardware in control.hardware:
            for first, plugin in zip(hardware.plugins, hardware.plugins[1:], strict=False):
                if side_by_side(project, first.at, plugin.at):
                    message = f"'{plugin.past_comments}' is not loaded: '{first.past_comments}' stands before it"
                    yield Finding(plugin.at, message, (Note("this one is before it", first.at),))
