"""UC342."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.robot import ComponentPart, Ros2Control
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import is_known, label
from urdfctl.rules.ros2_control.common import is_deaf, known_hardware, parts

_OLD_NAME = "initial_<interface>"


@rule(
    "UC342",
    severity=Severity.WARNING,
    runtime="ignores",
    distros=ROS2,
    authority="ros2_control component_parser.cpp reads initial_value only in interfaces; mock_components "
    'generic_system.cpp: "Parsing of optional initial interface values failed or uses a deprecated '
    'format"',
    options=["--distro=jazzy"],
    bad=[
        {
            "robot.urdf": """
                <ros2_control name="arm" type="system">
                  <hardware><plugin>mock_components/GenericSystem</plugin></hardware>
                  <joint name="elbow">
                    «<param name="initial_position">»0.5</param>
                    <command_interface name="position"/>
                    <state_interface name="position"/>
                  </joint>
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
                    <state_interface name="position"><param name="initial_value">0.5</param></state_interface>
                  </joint>
                </ros2_control>
            """,
        },
    ],
)
def initial_value_of_joint(project: Project) -> Iterator[Finding]:
    """Initial value in a joint instead of its interface.

    It is ignored there, and the joint starts at 0. Up to iron, mock hardware still accepted `initial_position` of a
    joint.
    """
    for control, part in parts(project):
        for parameter in part.parameters:
            name = parameter.name or ""
            is_initial = name == "initial_value" or (name.startswith("initial_") and _is_old(project, control))
            if not is_initial or not is_known(name) or not _of_interface(part, name):
                continue
            interface = name.removeprefix("initial_").replace("value", "position")
            element = f'<state_interface name="{interface}"><param name="initial_value">{parameter.value}</param>'
            message = f"parameter '{name}' of {label(part.kind, part.name)} is ignored; move it into the interface"
            yield Finding(parameter.at, message, fix=Fix(f"write {element}"))


def _is_old(project: Project, control: Ros2Control) -> bool:
    """Whether the component's hardware ignores an initial value of a joint, or its support is deprecated."""
    known = [(each.joint_parameters or {}).get(_OLD_NAME) for each in known_hardware(project, control)]
    return is_deaf(project, control, _OLD_NAME) or any(
        parameter is not None and parameter.deprecated for parameter in known
    )


def _of_interface(part: ComponentPart, name: str) -> bool:
    return name == "initial_value" or any(name == f"initial_{interface.name}" for interface in part.interfaces)
