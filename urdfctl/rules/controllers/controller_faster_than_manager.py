"""UC427."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import since
from urdfctl.model.parameters import Kind, Value
from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in

_DEFAULT = 100


@rule(
    "UC427",
    severity=Severity.WARNING,
    distros=since("humble"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: 'The controller : arm update rate : 200 Hz "
    "should be less than or equal to controller manager's update rate : 100 Hz!'",
    options=["--distro=jazzy"],
    bad={
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
    good={
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
)
def controller_faster_than_manager(project: Project) -> Iterator[Finding]:
    """A controller shall run at a higher rate than its manager, or at one that the manager's is no multiple of.

    A controller is updated in the manager's loop: never more often, and at a rate that does not divide the manager's
    at uneven times.
    """
    for controller in controllers_in(project).controllers:
        manager = controller.manager
        rate, whole = controller.parameters.value("update_rate"), None
        if manager is not None:
            whole = manager.parameters.value("update_rate")
        own, managers = _rate(rate), _DEFAULT if whole is None else _rate(whole)
        if manager is None or rate is None or own is None or managers is None or managers % own == 0:
            continue
        notes = (Note(f"the rate of '{manager.name}' stands here", whole.at),) if whole else ()
        words = "is higher than" if own > managers else "does not divide"
        message = f"the update rate of '{controller.name}' is {own} Hz, which {words} the {managers} Hz of its manager"
        yield Finding(rate.at, message, notes, severity=None if own > managers else Severity.INFO)


def _rate(value: Value | None) -> int | None:
    """A rate that is a whole number above 0; of another nothing is said here."""
    rate = value.value if value is not None and value.kind is Kind.INT else None
    return rate if isinstance(rate, int) and rate > 0 else None
