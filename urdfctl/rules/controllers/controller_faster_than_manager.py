"""UC427."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.model.controllers import Value, ValueKind
from urdfctl.rule import Finding, Note, Project, Severity, rule

_DEFAULT = 100
"""Update rate of a controller manager in Hz if none is given."""


@rule(
    "UC427",
    runtime="misbehaves",
    severity=Severity.WARNING,
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'The controller : arm update rate : 200 Hz "
    "should be less than or equal to controller manager's update rate : 100 Hz!'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
                    update_rate: «200»
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    arm: {type: forward_command_controller/ForwardCommandController}
                arm:
                  ros__parameters:
                    joints: [shoulder, elbow]
                    interface_name: position
                    update_rate: 50
            """
        },
    ],
)
def controller_faster_than_manager(project: Project) -> Iterator[Finding]:
    """Controller update rate exceeds or does not divide its manager's rate.

    The controller manager updates controllers in its own loop, so no controller runs faster than this loop. At a rate
    that does not divide the manager's, a controller is updated at uneven intervals.
    """
    for controller in controllers_in(project).controllers:
        manager = controller.manager
        value = controller.parameters.value("update_rate")
        manager_value = manager.parameters.value("update_rate") if manager is not None else None
        rate, manager_rate = _rate(value), _DEFAULT if manager_value is None else _rate(manager_value)
        if manager is None or value is None or rate is None or manager_rate is None or manager_rate % rate == 0:
            continue
        notes = (Note(f"rate of '{manager.name}' is set here", manager_value.at),) if manager_value else ()
        is_faster = rate > manager_rate
        relation = "is higher than" if is_faster else "does not divide"
        message = (
            f"update rate of controller '{controller.name}' is {rate} Hz, "
            f"which {relation} the {manager_rate} Hz of its manager"
        )
        yield Finding(value.at, message, notes, severity=None if is_faster else Severity.INFO)


def _rate(value: Value | None) -> int | None:
    """The rate if it is an integer above 0, else None."""
    rate = value.value if value is not None and value.kind is ValueKind.INT else None
    return rate if isinstance(rate, int) and rate > 0 else None
