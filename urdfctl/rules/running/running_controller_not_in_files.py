"""UC833."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controller, controllers_in, example


def _break(recording: Recorded) -> None:
    controllers_in(recording).append(controller("old_head", "active", "a/B", ["pan/position"]))


@fault(
    "UC833",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="it holds what another one needs",
    authority="ros2_control controller_manager.cpp: an interface has one claimer",
    bad=[example(_break)],
    good=[example()],
)
def running_controller_not_in_files(controller: str, holds: str) -> str:
    """Controller is active that the files do not have.

    Somebody loaded it by hand, or an older launch file was started. It holds interfaces that others need.
    """
    return f"controller '{controller}' is active, but the files do not have it{holds}; deactivate it"
