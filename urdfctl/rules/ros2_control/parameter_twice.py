"""UC340."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import HardwareParameter
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.common import is_known
from urdfctl.rules.ros2_control.common import parameters, side_by_side


@rule(
    "UC340",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control hardware_interface/src/component_parser.cpp parse_parameters_from_xml(): a later "
    "parameter replaces an earlier one of the same name",
    bad=[
        {
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
    ],
    good=[
        {
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
    ],
)
def parameter_twice(project: Project) -> Iterator[Finding]:
    """Duplicate parameter in a component.

    The last value is used, without a message.
    """
    for of, given in parameters(project):
        first: dict[str, HardwareParameter] = {}
        for parameter in given:
            name = parameter.name
            if name is None or not is_known(name):
                continue
            before = first.setdefault(name, parameter)
            if before is not parameter and side_by_side(project, before.at, parameter.at):
                is_same = before.value == parameter.value
                effect = " with the same value" if is_same else f"; '{parameter.value}' is used"
                message = f"parameter '{name}' of {of} is set twice{effect}"
                notes = (Note("first set here", before.at["name"]),)
                yield Finding(parameter.at["name"], message, notes, severity=Severity.INFO if is_same else None)
