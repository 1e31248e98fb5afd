"""UC801."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example, silent_manager, without_node


def _break(recording: Recorded) -> None:
    silent_manager(recording)
    without_node(recording, "controller_manager")


@fault(
    "UC801",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="controller_manager ros2_control_node.cpp: the node offers ~/list_controllers as long as it runs",
    bad=[example(_break)],
    good=[example()],
)
def manager_not_running(manager: str, instead: str = "") -> str:
    """Controller manager of the files is not running.

    No node has its name. It ended, is stopped, or was started in another namespace: look at its last lines in the log.
    """
    why = instead or ": it has ended, hangs, or was never started; look at its log"
    return f"controller manager '{manager}' is not running{why}"
