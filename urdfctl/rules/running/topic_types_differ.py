"""UC851."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example


def _break(recording: Recorded) -> None:
    recording["topics"][1]["publishers"] = [end("/script", "std_msgs/msg/Float64")]


@fault(
    "UC851",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="nothing moves",
    authority="rmw: ends of different types do not match, although they have one name",
    bad=[example(_break)],
    good=[example()],
)
def topic_types_differ(topic: str, published: str, read: str) -> str:
    """Topic is published with another type than it is read with.

    Since jazzy drive controllers read TwistStamped only. The messages never arrive, and counts look right.
    """
    return f"{topic} is published as {published}, but read as {read}: no message arrives"
