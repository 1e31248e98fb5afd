"""UC434."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import Reader, in_each_distro
from urdfctl.control.parameters.rules import breaches
from urdfctl.rule import Finding, Project, Severity, StageDependsOn, rule
from urdfctl.rules.controllers.parameters import is_sound


@rule(
    "UC434",
    stage=StageDependsOn.MANAGER,
    severity=Severity.ERROR,
    runtime="refuses",
    authority="the controllers' own checks, e.g. joint_trajectory_controller: ''velocity' command interface can only be "
    "used alone if 'velocity' and 'position' state interfaces are present'",
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
                    right_wheel_names: «[elbow, wrist]»
                    wheel_separation: 0.4
                    wheel_radius: 0.1
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
def parameters_not_fitting(project: Project) -> Iterator[Finding]:
    """Inconsistent controller parameters.

    Each value may be valid by itself. But lists must have the same length, interfaces must form a supported
    combination, or one of several groups must be given. The controller checks these conditions and refuses to start.
    """
    return in_each_distro(project, _unfit)


def _unfit(reader: Reader) -> Iterator[Finding]:
    if reader.type is None:
        return
    for breach in breaches(reader.type, reader.given):
        given = reader.located.get(breach.parameter)
        checked = (*breach.rule.params, str(breach.rule.details.get("of_param", "")))
        if given is None or not all(is_sound(reader, name) for name in checked):
            continue  # reported by UC431, UC432, UC433 and UC407
        severity = Severity.ERROR if breach.rule.severity == "error" else Severity.WARNING
        yield Finding(given.value.at, f"'{given.name}' {breach.message}", severity=severity)
