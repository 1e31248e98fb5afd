"""UC831."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controllers_in, example


def _break(recording: Recorded) -> None:
    del controllers_in(recording)[1]
    values = recording["parameters"]["/controller_manager"]["values"]
    values["head.type"] = "forward_command_controller/ForwardComandController"


@fault(
    "UC831",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: 'Loader for controller '%s' (type '%s') not found.'",
    bad=[example(_break)],
    good=[example()],
)
def running_type_unknown(controller: str, running: str, files: str) -> str:
    """Controller is to be loaded with a type that is not installed.

    The parameter of the running manager names the type: an older file was started, or the type is misspelt there.
    """
    return f"controller '{controller}' has type '{running}' in the running manager, which it cannot load{files}"
