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
    distros=ROS2,
    authority='pluginlib class_loader: "the class mock_components/GenericSystem with base class type '
    'hardware_interface::SensorInterface does not exist"',
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="«actuator»">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
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
def hardware_plugin_of_other_type(project: Project) -> Iterator[Finding]:
    """A component's plugin is of another type than the component.

    The type decides in which list the plugin is looked for, and there it is not: the component is not loaded, and the
    description refused. Where a condition chooses the plugin, this holds for these arguments.
    """
    for control in components(project):
        kind = (control.type or "").strip()
        found = known_hardware(project, control)
        if kind not in TYPES or not found or any(kind in each.component_types for each in found):
            continue
        right = found[0].component_types[0]
        message = (
            f"'{found[0].type}' is a {right}, and {component(control)} is of type '{kind}'; write type=\"{right}\""
        )
        fix = replaced(control.at["type"], control.type or "", right)
        severity = Severity.WARNING if is_conditional(control.hardware[-1].at) else Severity.ERROR
        yield Finding(control.at["type"], message, fix=fix, severity=severity)
