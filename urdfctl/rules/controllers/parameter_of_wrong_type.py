"""UC432."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.catalog.entries import Parameter
from urdfctl.catalog.value_types import type_problem
from urdfctl.model.parameters import Kind, Value
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.controllers.parameters import is_ros1, known_as
from urdfctl.rules.controllers.readers import Reader, in_each_distro


@rule(
    "UC432",
    severity=Severity.ERROR,
    authority="rclcpp: 'Wrong parameter type, parameter {joints} is of type {string_array}, setting it to {string} is "
    "not allowed.'; roscpp's getParam gives nothing where the type is another",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def parameter_of_wrong_type(project: Project) -> Iterator[Finding]:
    """A parameter has a value of another type than its node reads.

    From galactic on ROS 2 refuses it, an integer for a number with a decimal point too: the controller is not loaded, or
    the manager ends. ROS 1 takes integers as numbers; what it cannot read counts as not given.
    """
    return in_each_distro(project, _wrong)


def _wrong(reader: Reader) -> Iterator[Finding]:
    for given in reader.located:
        found = known_as(reader, given.name)
        if found is None:
            continue
        parameter = reader.known[found[0]]
        if parameter.ignored or (given.value.kind is Kind.MAP and given.name in _fathers(reader)):
            continue
        if given.value.kind is Kind.NULL:
            continue  # UC406 tells it
        if not is_ros1(reader) and len({item.kind for item in given.value.items}) > 1:
            continue  # UC408 tells it
        value: object = {} if given.value.kind is Kind.MAP else reader.given.get(given.name)
        problem = type_problem(value, parameter, reader.distro)
        if problem is not None:
            message = f"'{given.name}' {problem}"
            dire = parameter.needed or parameter.floats_only or parameter.if_absent == "crash"
            refused = not is_ros1(reader) or dire
            severity = Severity.ERROR if refused else Severity.WARNING
            yield Finding(given.value.at, message, fix=_fix(given.value, parameter), severity=severity)


def _fathers(reader: Reader) -> set[str]:
    """The maps in which known parameters stand."""
    return {name.partition(".")[0] for name in reader.known if "." in name}


def _fix(value: Value, parameter: Parameter) -> Fix | None:
    """A decimal point for integers where numbers are wanted; the value without quotes, where that is one."""
    if "double" in parameter.type:
        integers = [item for item in (value.items or (value,)) if item.kind is Kind.INT]
        if integers and all(re.fullmatch(r"[+-]?[0-9]+", item.at.span.text) for item in integers):
            edits = tuple(Edit(item.at.span, f"{item.text}.0") for item in integers)
            return Fix("write a decimal point", edits, safe=True)
    if parameter.type == "string_array" and value.kind is Kind.STRING and value.text == value.at.span.text:
        return Fix("write a list", (Edit(value.at.span, f"[{value.text}]"),))
    return None
