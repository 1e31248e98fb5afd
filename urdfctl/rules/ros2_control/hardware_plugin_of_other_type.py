"""UC354."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_conditional, replaced
from urdfctl.rules.ros2_control.common import component, components, known_hardware
from urdfctl.rules.ros2_control.facts import TYPES


@rule(
    "UC354",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority='pluginlib class_loader: "the class mock_components/GenericSystem with base class type '
    'hardware_interface::SensorInterface does not exist"',
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="«actuator»">
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
def hardware_plugin_of_other_type(project: Project) -> Iterator[Finding]:
    """Component and its plugin have different types.

    The type selects the list in which the plugin is looked up, and it is not in that list. The component is not loaded,
    and the description is rejected. If a condition chooses the plugin, this applies to the given arguments.
    """
    for control in components(project):
        kind = (control.type or "").strip()
        hardware = known_hardware(project, control)
        if kind not in TYPES or not hardware or any(kind in each.component_types for each in hardware):
            continue
        expected = hardware[0].component_types[0]
        message = (
            f"plugin '{hardware[0].type}' is of type '{expected}', but {component(control)} is of type '{kind}'; "
            f'use type="{expected}"'
        )
        fix = replaced(control.at["type"], control.type or "", expected)
        severity = Severity.WARNING if is_conditional(control.hardware[-1].at) else Severity.ERROR
        yield Finding(control.at["type"], message, fix=fix, severity=severity)
