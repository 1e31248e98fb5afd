"""UC806."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example, without_node


def _break(recording: Recorded) -> None:
    without_node(recording, "robot_state_publisher")
    del recording["parameters"]["/robot_state_publisher"]


@fault(
    "UC806",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="links have no poses",
    authority="robot_state_publisher.cpp publishes the transforms of links and /robot_description; a manager that starts later waits for it",
    bad=[example(_break)],
    good=[example()],
)
def state_publisher_not_running(node: str) -> str:
    """Node that publishes the transforms does not run.

    RViz shows no links, and a controller manager that starts later gets no description.
    """
    return f"{node} is not running: links have no transforms; look for why it ended in its log"
