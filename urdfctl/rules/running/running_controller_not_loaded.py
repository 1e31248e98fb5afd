"""UC830."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controllers_in, example


def _break(recording: Recorded) -> None:
    del controllers_in(recording)[1]


@fault(
    "UC830",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: 'Could not find controller with name '%s''; a controller whose initialisation fails is not listed",
    bad=[example(_break)],
    good=[example()],
)
def running_controller_not_loaded(controller: str, manager: str, why: str) -> str:
    """Controller of the files is not loaded.

    No spawner asked for it, or its initialisation failed: its parameters are missing, wrong, or were given to another
    namespace.
    """
    return f"controller '{controller}' is not loaded in '{manager}': {why}"
