"""UC352."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import label, replaced
from urdfctl.rules.ros2_control.common import called, interfaces

_MEANT = {
    "min": "min",
    "max": "max",
    "minimum": "min",
    "maximum": "max",
    "lower": "min",
    "upper": "max",
    "initialvalue": "initial_value",
    "initial_value": "initial_value",
}


@rule(
    "UC352",
    severity=Severity.WARNING,
    distros=ROS2,
    authority='ros2_control hardware_interface/src/component_parser.cpp: "Jerk only accepts max limits."; it looks '
    "for min and max in small letters",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position">
                  <param name="«Min»">-1</param>
                </command_interface>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
              <joint name="elbow">
                <command_interface name="position">
                  <param name="min">-1</param>
                </command_interface>
                <state_interface name="position"/>
              </joint>
            </ros2_control>
        """,
    },
)
def interface_limit_not_read(project: Project) -> Iterator[Finding]:
    """A limit of an interface is written so that it is not read.

    Its parameter is `min` or `max` in small letters, and jerk has a max alone.
    """
    for part, interface in interfaces(project):
        of = f"{called(interface)} of {label(part.kind, part.name)}"
        for parameter in interface.parameters:
            name = parameter.name or ""
            meant = _MEANT.get(name.lower())
            if meant and meant != name:
                at = parameter.at["name"]
                fix = replaced(at, name, meant, safe=name.lower() == meant)
                yield Finding(at, f"'{name}' of {of} is not read; did you mean '{meant}'?", fix=fix)
            elif name == "min" and interface.name == "jerk" and interface.kind == "command":
                yield Finding(parameter.at, f"'min' of {of} is not read: jerk has a 'max' alone, for both directions")
