"""UC834."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["parameters"]["/head"]["values"]["joints"] = ["tilt", "pan"]


@fault(
    "UC834",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="what runs is not what was built",
    authority="rclcpp: a node keeps the parameters that it was started with",
    bad=[example(_break)],
    good=[example()],
)
def running_parameter_differs(node: str, parameter: str, running: str, files: str) -> str:
    """Parameter of a running node differs from the files.

    An older build was started, the file was changed since, or another file or section gave the value.
    """
    return f"{node} runs with {parameter} = {running}, the files say {files}; rebuild, source and start it again"
