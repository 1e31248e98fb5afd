"""UC356."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.names import nearest
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_conditional, is_known, replaced
from urdfctl.rules.ros2_control.common import components, known_hardware


@rule(
    "UC356",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="mock_components generic_system.cpp and others look up parameters by exact names; others are "
    "silently ignored",
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware>
                    <plugin>mock_components/GenericSystem</plugin>
                    <param name="«state_following_offset»">0.1</param>
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
                    <param name="position_state_following_offset">0.1</param>
                  </hardware>
                  <joint name="elbow"><command_interface name="position"/><state_interface name="position"/></joint>
                </ros2_control>
            """,
        },
    ],
)
def hardware_parameter_unknown(project: Project) -> Iterator[Finding]:
    """Unknown or deprecated hardware parameter.

    The plugin ignores an unknown parameter without a message and uses the default. If conditions choose the plugin,
    parameters of the other plugin are accepted.
    """
    for control in components(project):
        hardware = [each for each in known_hardware(project, control) if each.hardware_parameters is not None]
        for parameter in control.hardware[-1].parameters if hardware else ():
            name = parameter.name
            if not name or not is_known(name):
                continue
            of_each = [(each.hardware_parameters or {}).get(name) for each in hardware]
            if any(each is not None and not each.deprecated for each in of_each):
                continue
            former = next((each for each in of_each if each is not None), None)
            known = [other for each in hardware for other in each.hardware_parameters or ()]
            meant = former.replacement if former and former.replacement else nearest(name, known)
            if meant is None and is_conditional(control.hardware[-1].at):
                continue
            at = parameter.at["name"]
            if former:
                message = f"parameter '{name}' of '{hardware[0].type}' is deprecated"
                message += f"; use '{meant}'" if meant else ""
            else:
                message = f"'{hardware[0].type}' has no parameter '{name}'"
                message += f"; did you mean '{meant}'?" if meant else "; it is ignored"
            yield Finding(at, message, fix=replaced(at, name, meant) if meant else None)
