"""UC364."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import parameters


@rule(
    "UC364",
    severity=Severity.ERROR,
    distros=until("galactic"),
    authority='ros2_control hardware_interface/src/component_parser.cpp up to galactic: "text not specified in the '
    '<name> tag"',
    options=["--distro=foxy"],
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>
                <plugin>my_robot/MyHardware</plugin>
                «<param name="calibration">»</param>
              </hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>
                <plugin>my_robot/MyHardware</plugin>
                <param name="calibration">calibration.yaml</param>
              </hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
)
def parameter_empty(project: Project) -> Iterator[Finding]:
    """A parameter of a component is empty.

    Up to galactic the description is refused; from humble on it is an empty text, which hardware may take for none.
    """
    if not set(project.distros) <= set(until("galactic")):
        return
    for of, found in parameters(project):
        for parameter in found:
            if not parameter.value and parameter.name:
                yield Finding(parameter.at, f"the parameter '{parameter.name}' of {of} is empty")
