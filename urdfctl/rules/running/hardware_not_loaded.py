"""UC803."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example, silent_manager


def _break(recording: Recorded) -> None:
    silent_manager(recording)


@fault(
    "UC803",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control resource_manager.cpp: 'Caught exception of type : %s while loading hardware: %s'; the manager's services appear only after the hardware is initialised",
    bad=[example(_break)],
    good=[example()],
)
def hardware_not_loaded(manager: str, plugins: str) -> str:
    """Controller manager cannot load the hardware.

    It has the description, and offers no services: a hardware plugin that the description names is not installed, or
    cannot be initialised. Its log names the exception.
    """
    advice = "install the package that exports it, source its workspace, and look at the manager's log"
    return f"controller manager '{manager}' does not answer: it did not load hardware plugin {plugins}; {advice}"
