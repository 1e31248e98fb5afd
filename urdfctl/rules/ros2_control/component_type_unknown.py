"""UC303."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_known, replaced
from urdfctl.rules.ros2_control.common import component, components
from urdfctl.rules.ros2_control.facts import TYPES
from urdfctl.suggest import nearest


@rule(
    "UC303",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/resource_manager.cpp compares the type with system, actuator and"
    " sensor, and passes over a component of any other",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="«System»">
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
def component_type_unknown(project: Project) -> Iterator[Finding]:
    """A component's type is none of system, actuator and sensor.

    Nothing is said of the type itself: the component is not loaded, and its interfaces are missing. From jazzy on the
    controller manager then refuses the description. Letters count: `System` is none of them.
    """
    for control in components(project):
        kind = control.type
        if kind is None or not is_known(kind) or kind.strip() in TYPES:
            continue
        right = kind.strip().lower()
        meant = right if right in TYPES else nearest(right, TYPES)
        what = f"'{meant}'" if meant else "'system', 'actuator' or 'sensor'"
        at = control.at["type"]
        fix = replaced(at, kind, meant, safe=meant == right) if meant else None
        yield Finding(at, f"unknown type '{kind}' of {component(control)}, which is not loaded; write {what}", fix=fix)
