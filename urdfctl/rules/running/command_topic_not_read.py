"""UC850."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, topic


def _break(recording: Recorded) -> None:
    recording["topics"].append(topic("/hed/commands", [end("/script", "std_msgs/msg/Float64MultiArray")], []))


@fault(
    "UC850",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="nothing moves",
    authority="rclcpp: a topic without subscription takes messages and says nothing",
    bad=[example(_break)],
    good=[example()],
)
def command_topic_not_read(topic: str, node: str, near: str) -> str:
    """Commands are published on a topic that nobody reads.

    A controller reads a topic with nearly this name, and nobody publishes there.
    """
    return f"{node} publishes on {topic}, which nobody reads; {near} is what a controller reads"
