"""UC434."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameter_rules import breaches
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.parameters import is_sound
from urdfctl.rules.controllers.readers import Reader, in_each_distro


@rule(
    "UC434",
    severity=Severity.ERROR,
    authority="the controllers' own checks, as joint_trajectory_controller's: ''velocity' command interface can only be "
    "used alone if 'velocity' and 'position' state interfaces are present'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def parameters_not_fitting(project: Project) -> Iterator[Finding]:
    """Parameters of a controller do not fit together.

    Each may be right by itself: the controller checks lists that must be of one length, interfaces that go together
    only in some combinations, groups of which one must be chosen.
    """
    return in_each_distro(project, _unfit)


def _unfit(reader: Reader) -> Iterator[Finding]:
    if reader.type is None:
        return
    for breach in breaches(reader.type, reader.given):
        given = reader.located.get(breach.parameter)
        asked = (*breach.rule.params, str(breach.rule.details.get("of_param", "")))
        if given is None or not all(is_sound(reader, name) for name in asked):
            continue  # UC431, UC432, UC433 and UC407 tell them
        severity = Severity.ERROR if breach.rule.severity == "error" else Severity.WARNING
        yield Finding(given.value.at, f"'{given.name}' {breach.message}", severity=severity)
