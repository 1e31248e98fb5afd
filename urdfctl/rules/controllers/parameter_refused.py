"""UC433."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.entries import ParameterEntry
from urdfctl.catalog.validators import problem
from urdfctl.catalog.value_types import shown, type_problem
from urdfctl.catalog.values import is_list
from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.model.controllers import Value, ValueKind
from urdfctl.names import nearest
from urdfctl.rule import Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.parameters import is_ros1, known_as


@rule(
    "UC433",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="generate_parameter_library: 'Invalid value set during initialization for parameter ...'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [shoulder]
                    right_wheel_names: [elbow]
                    wheel_separation: 0.4
                    wheel_radius: «0.0»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    base: {type: diff_drive_controller/DiffDriveController}
                base:
                  ros__parameters:
                    left_wheel_names: [shoulder]
                    right_wheel_names: [elbow]
                    wheel_separation: 0.4
                    wheel_radius: 0.1
            """
        },
    ],
)
def parameter_refused(project: Project) -> Iterator[Finding]:
    """Parameter value that the node refuses.

    Controllers check their parameters: numbers must be in a range, lists must not be empty or contain duplicates,
    strings must be one of the allowed values. A controller with another value is not loaded.
    """
    return in_each_distro(project, _refused)


def _refused(reader: Reader) -> Iterator[Finding]:
    for given in reader.located:
        matched = known_as(reader, given.name)
        value = reader.given.get(given.name)
        if matched is None or value is None or given.value.kind is ValueKind.MAP:
            continue
        parameter = reader.known[matched[0]]
        if parameter.ignored or (value == [] and not is_ros1(reader)) or type_problem(value, parameter, reader.distro):
            continue  # reported by UC438, UC407 and UC432
        for limits, severity in ((parameter.validators, Severity.ERROR), (parameter.useful, Severity.WARNING)):
            broken = problem(value, limits)
            if broken is not None:
                actual = "" if is_list(value) or broken.startswith("must not") else f", not {shown(value)}"
                message = f"'{given.name}' {broken}{actual}"
                yield Finding(given.value.at, message, fix=_fix(given.value, parameter), severity=severity)
                break


def _fix(value: Value, parameter: ParameterEntry) -> Fix | None:
    choices = parameter.validators.get("one_of")
    meant = nearest(value.text, map(str, choices)) if isinstance(choices, list) else None
    return replaced(value.at, value.text, meant) if meant else None
