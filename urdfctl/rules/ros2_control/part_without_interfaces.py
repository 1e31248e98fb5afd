"""UC335."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_all_there, is_conditional
from urdfctl.rules.ros2_control.common import followers, known_hardware, of_part, parts
from urdfctl.rules.ros2_control.facts import INTERFACE_ELEMENTS


@rule(
    "UC335",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority='ros2_control hardware_interface/src/resource_manager.cpp: "Importing state interfaces for the '
    "hardware 'arm' returned no state interfaces.\"",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                  «<joint name="shoulder"/>»
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
def part_without_interfaces(project: Project) -> Iterator[Finding]:
    """Joint, sensor or gpio without interfaces.

    Nothing of it can be read or commanded. Three cases are accepted: a joint that only mimics another, a part with
    parameters for the hardware, and an empty gpio of real hardware.
    """
    mimics = {id(joint) for joint, _ in followers(project)}
    for control, part in parts(project):
        if part.interfaces or part.parameters or id(part) in mimics or not is_all_there(project, part.tag):
            continue
        if any(nearest(other.name, INTERFACE_ELEMENTS) for other in part.others):
            continue
        if part.kind == "gpio" and not any(each.simulator for each in known_hardware(project, control)):
            continue
        severity = Severity.INFO if is_conditional(part.at) else Severity.WARNING
        yield Finding(part.at, f"{of_part(control, part)} has no command or state interface", severity=severity)
