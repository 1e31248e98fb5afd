"""UC340."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.ros2_control import Parameter
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import parameters, side_by_side


@rule(
    "UC340",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp parse_parameters_from_xml(): a later "
    "parameter of a name takes the earlier one's place",
    bad={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>
                <plugin>mock_components/GenericSystem</plugin>
                <param name="calculate_dynamics">true</param>
                <param name="«calculate_dynamics»">false</param>
              </hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
    good={
        "robot.urdf": """
            <ros2_control name="arm" type="system">
              <hardware>
                <plugin>mock_components/GenericSystem</plugin>
                <param name="calculate_dynamics">true</param>
              </hardware>
              <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
            </ros2_control>
        """,
    },
)
def parameter_twice(project: Project) -> Iterator[Finding]:
    """A parameter is given twice.

    The last one counts, without a word.
    """
    for of, found in parameters(project):
        first: dict[str, Parameter] = {}
        for parameter in found:
            name = parameter.name
            if name is None or not is_known(name):
                continue
            before = first.setdefault(name, parameter)
            if before is not parameter and side_by_side(project, before.at, parameter.at):
                same = (
                    ", with the same value" if before.value == parameter.value else f", and '{parameter.value}' counts"
                )
                severity = Severity.INFO if before.value == parameter.value else None
                message = f"{of} already has a parameter '{name}'{same}"
                yield Finding(
                    parameter.at["name"], message, (Note("it is here", before.at["name"]),), severity=severity
                )
