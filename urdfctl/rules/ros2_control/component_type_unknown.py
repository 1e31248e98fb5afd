"""UC303."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.rules.ros2_control.facts import TYPES


@rule(
    "UC303",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/resource_manager.cpp compares the type with system, actuator and"
    " sensor, and skips a component of any other type",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="«System»">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
        {
            "robot.urdf": """
                <ros2_control name="arm" type="«sensors»">
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
def component_type_unknown(project: Project) -> Iterator[Finding]:
    """Unknown component type.

    The component is not loaded, and its interfaces are missing; no message mentions the type. Since jazzy, the
    controller manager then rejects the description. The type is case-sensitive: `System` is not accepted.
    """
    for control in components(project):
        kind = control.type
        if kind is None or not is_known(kind) or kind.strip() in TYPES:
            continue
        lowered = kind.strip().lower()
        meant = lowered if lowered in TYPES else nearest(lowered, TYPES)
        expected = f"'{meant}'" if meant else "'system', 'actuator' or 'sensor'"
        at = control.at["type"]
        fix = replaced(at, kind, meant, safe=meant == lowered) if meant else None
        yield Finding(at, f"{component(control)} has unknown type '{kind}' and is not loaded; use {expected}", fix=fix)
