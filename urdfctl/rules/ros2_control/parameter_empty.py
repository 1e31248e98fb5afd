"""UC364."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.ros2_control.common import parameters


@rule(
    "UC364",
    severity=Severity.ERROR,
    runtime="refuses",
    distros=until("galactic"),
    authority='ros2_control hardware_interface/src/component_parser.cpp up to galactic: "text not specified in the '
    '<name> tag"',
    options=["--distro=foxy"],
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def parameter_empty(project: Project) -> Iterator[Finding]:
    """Empty parameter in a component.

    Up to galactic, the description is rejected. Since humble, the value is an empty string, which hardware may treat as
    missing.
    """
    if not set(project.distros) <= set(until("galactic")):
        return
    for of, given in parameters(project):
        for parameter in given:
            if not parameter.value and parameter.name:
                message = f"parameter '{parameter.name}' of {of} is empty; galactic and earlier reject the description"
                yield Finding(parameter.at, message)
