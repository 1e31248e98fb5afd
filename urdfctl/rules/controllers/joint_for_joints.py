"""UC444."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.model.controllers import Parameter, Value, ValueKind
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, StageDependsOn, rule
from urdfctl.rules.controllers.parameters import missing, number_slips, slips, unread


@rule(
    "UC444",
    stage=StageDependsOn.PARAMETER_CHECKS,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_controllers effort_controllers/src/joint_position_controller.cpp: 'No joint given (namespace: /arm)'; "
    "forward_command_controller: ''joints' parameter was empty'",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                elbow_controller:
                  type: position_controllers/JointPositionController
                  «joints»: [elbow]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                elbow_controller:
                  type: position_controllers/JointPositionController
                  joint: elbow
            """
        },
    ],
)
def joint_for_joints(project: Project) -> Iterator[Finding]:
    """Parameter `joint` instead of `joints`, or the reverse.

    Controllers of one joint read its name from `joint`; controllers of several joints read a list from `joints`. A
    controller that does not find its joints is not loaded or not configured.
    """
    return in_each_distro(project, _slip)


def _slip(reader: Reader) -> Iterator[Finding]:
    for parameter in unread(reader):
        others = number_slips(reader, parameter.name)
        right = slips(reader).get(parameter.name) if others else None
        if right is None or right not in others:
            continue
        needed = {lack.name for lack in missing(reader) if lack.refused}
        node = f"controller type '{reader.type.type}'" if reader.type else f"'{reader.name}'"
        wants_list = reader.known[right].type.endswith("_array")
        form = "a list" if wants_list else "one name"
        message = f"{node} has no parameter '{parameter.name}'; use '{right}' ({form})"
        severity = Severity.ERROR if right in needed else Severity.WARNING
        yield Finding(parameter.key, message, fix=_fix(parameter, right, wants_list=wants_list), severity=severity)


def _fix(parameter: Parameter, right: str, *, wants_list: bool) -> Fix | None:
    value = _rewritten(parameter.value, wants_list=wants_list)
    if value is None or parameter.key.span.text != parameter.last:
        return None
    edits = (Edit(parameter.key.span, right.rpartition(".")[2]), Edit(parameter.value.at.span, value))
    return Fix(f"write '{right}: {value}'", edits)


def _rewritten(value: Value, *, wants_list: bool) -> str | None:
    """The source text of one name as a list, or of a list of one name as a name; None for other values."""
    if wants_list and value.kind is ValueKind.STRING:
        return f"[{value.at.span.text}]"
    if not wants_list and len(value.items) == 1:
        return value.items[0].at.span.text
    return value.at.span.text if wants_list == (value.kind is ValueKind.LIST) else None
