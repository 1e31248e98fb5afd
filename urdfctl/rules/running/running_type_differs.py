"""UC835."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controllers_in, example


def _break(recording: Recorded) -> None:
    controllers_in(recording)[1]["type"] = "position_controllers/JointGroupPositionController"


@fault(
    "UC835",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="another controller moves the joints",
    authority="controller_manager.cpp load_controller: the type is the parameter NAME.type of the manager that runs",
    bad=[example(_break)],
    good=[example()],
)
def running_type_differs(controller: str, running: str, files: str) -> str:
    """Running controller has another type than in the files.

    An older parameter file was started, or a launch file overrides the type.
    """
    return f"controller '{controller}' runs as {running}, the files say {files}; rebuild, source and start it again"
