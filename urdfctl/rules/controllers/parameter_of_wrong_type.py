"""UC432."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.value_types import type_problem
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.model.controllers import Value, ValueKind
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.controllers.parameters import is_ros1, known_as


@rule(
    "UC432",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="rclcpp: 'Wrong parameter type, parameter {joints} is of type {string_array}, setting it to {string} is "
    "not allowed.'; roscpp's getParam fails if the type differs",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
                    action_monitor_rate: «20»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: joint_trajectory_controller/JointTrajectoryController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    command_interfaces: [position]
                    state_interfaces: [position]
                    action_monitor_rate: 20.0
            """
        },
    ],
)
def parameter_of_wrong_type(project: Project) -> Iterator[Finding]:
    """Parameter value of the wrong type.

    ROS 2 refuses it from galactic on, even an integer for a number with a decimal point: the controller is not loaded,
    or the manager exits. ROS 1 accepts integers as numbers; it treats a value that it cannot read as missing.
    """
    return in_each_distro(project, _wrong)


def _wrong(reader: Reader) -> Iterator[Finding]:
    for given in reader.located:
        matched = known_as(reader, given.name)
        if matched is None:
            continue
        parameter = reader.known[matched[0]]
        if parameter.ignored or (given.value.kind is ValueKind.MAP and given.name in _groups(reader)):
            continue
        if given.value.kind is ValueKind.NULL:
            continue  # UC406 reports it
        if not is_ros1(reader) and len({item.kind for item in given.value.items}) > 1:
            continue  # UC408 reports it
        value: object = {} if given.value.kind is ValueKind.MAP else reader.given.get(given.name)
        problem = type_problem(value, parameter, reader.distro)
        if problem is not None:
            message = f"'{given.name}' {problem}"
            ros1_refuses = parameter.needed or parameter.floats_only or parameter.if_absent == "crash"
            refused = ros1_refuses if is_ros1(reader) else not parameter.lenient
            severity = Severity.ERROR if refused else Severity.WARNING
            yield Finding(given.value.at, message, fix=_fix(given.value, parameter), severity=severity)


def _groups(reader: Reader) -> set[str]:
    """The top-level maps that contain known parameters."""
    return {name.partition(".")[0] for name in reader.known if "." in name}


def _fix(value: Value, parameter: ParameterEntry) -> Fix | None:
    """Add a decimal point to integers if a number is expected; put brackets around a string if a list is expected."""
    if "double" in parameter.type:
        integers = [item for item in (value.items or (value,)) if item.kind is ValueKind.INT]
        if integers and all(re.fullmatch(r"[+-]?[0-9]+", item.at.span.text) for item in integers):
            edits = tuple(Edit(item.at.span, f"{item.text}.0") for item in integers)
            return Fix("add a decimal point", edits, safe=True)
    if parameter.type == "string_array" and value.kind is ValueKind.STRING and value.text == value.at.span.text:
        return Fix("write it as a list", (Edit(value.at.span, f"[{value.text}]"),))
    return None
