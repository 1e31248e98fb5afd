"""UC852."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example


def _break(recording: Recorded) -> None:
    kind = "std_msgs/msg/Float64MultiArray"
    recording["topics"][1]["publishers"] = [end("/script", kind, reliability="best_effort")]


@fault(
    "UC852",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="nothing moves",
    authority="rmw QoS compatibility: a reliable or transient_local subscription gets nothing from a best_effort or volatile publisher",
    bad=[example(_break)],
    good=[example()],
)
def topic_qos_incompatible(topic: str, publisher: str, reader: str, quality: str) -> str:
    """Publisher offers less than the reader of its topic requires.

    No message arrives; both sides warn once in their logs.
    """
    return f"{reader} gets nothing on {topic}: {publisher} publishes it {quality}"
