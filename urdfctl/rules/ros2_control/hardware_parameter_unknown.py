"""UC356."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import is_conditional, is_known, replaced
from urdfctl.rules.ros2_control.common import components, known_hardware
from urdfctl.suggest import nearest


@rule(
    "UC356",
    severity=Severity.WARNING,
    distros=ROS2,
    authority="mock_components generic_system.cpp and others look for parameters by exact names; others are passed "
    "over without a word",
    bad={
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
    good={
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
)
def hardware_parameter_unknown(project: Project) -> Iterator[Finding]:
    """A component's plugin does not read one of its parameters, or soon will not.

    Nobody tells of it: the default counts. Where conditions choose the plugin, the parameters of the other one may
    stay.
    """
    for control in components(project):
        found = [each for each in known_hardware(project, control) if each.hardware_parameters is not None]
        for parameter in control.hardware[-1].parameters if found else ():
            name = parameter.name
            if not name or not is_known(name):
                continue
            of_each = [(each.hardware_parameters or {}).get(name) for each in found]
            if any(each is not None and not each.deprecated for each in of_each):
                continue
            former = next((each for each in of_each if each is not None), None)
            known = [other for each in found for other in each.hardware_parameters or ()]
            meant = former.replacement if former and former.replacement else nearest(name, known)
            if meant is None and is_conditional(control.hardware[-1].at):
                continue
            at = parameter.at["name"]
            what = "is deprecated" if former else "is not read"
            hint = f"; write '{meant}'" if former else f"; did you mean '{meant}'?"
            message = f"'{name}' {what} by '{found[0].type}'{hint if meant else ''}"
            yield Finding(at, message, fix=replaced(at, name, meant) if meant else None)
