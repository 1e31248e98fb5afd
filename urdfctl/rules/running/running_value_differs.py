"""UC812."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import DESCRIPTION, Recorded, example


def _break(recording: Recorded) -> None:
    recording["robot_description"]["/robot_description"] = [
        {"data": DESCRIPTION.replace('velocity="2"', 'velocity="1"')}
    ]


@fault(
    "UC812",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="what runs is not what was built",
    authority="robot_state_publisher and controller_manager keep the description that they were started with",
    bad=[example(_break)],
    good=[example()],
)
def running_value_differs(value: str, running: str, files: str) -> str:
    """Description that is running has other values than the files.

    An older build of the package was started: build, source and start again.
    """
    return f"the running description differs from the files: {value} is {running}, the files say {files}"
