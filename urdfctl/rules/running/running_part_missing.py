"""UC810."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import DESCRIPTION, Recorded, example


def _break(recording: Recorded) -> None:
    old = DESCRIPTION.replace("tilt", "nod")
    recording["robot_description"]["/robot_description"] = [{"data": old}]


@fault(
    "UC810",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="what runs is not what was built",
    authority="robot_state_publisher and controller_manager keep the description that they were started with",
    bad=[example(_break)],
    good=[example()],
)
def running_part_missing(what: str, where: str) -> str:
    """Description that is running has other parts than the files.

    An older build of the package was started, or another workspace is sourced: build, source and start again.
    """
    return f"the running description is not that of the files: {what}: {where}; rebuild and source the workspace"
