"""UC832."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controllers_in, example


def _break(recording: Recorded) -> None:
    controllers_in(recording)[1]["state"] = "inactive"


@fault(
    "UC832",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp switch_controller(): 'Unable to activate controller'",
    bad=[example(_break)],
    good=[example()],
)
def running_controller_not_active(controller: str, state: str, why: str) -> str:
    """Controller is not active.

    It is loaded, but holds no interfaces and commands nothing.
    """
    return f"controller '{controller}' is {state}, not active: {why}"
