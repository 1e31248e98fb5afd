"""UC862."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, topic


def _break(recording: Recorded) -> None:
    kind = "tf2_msgs/msg/TFMessage"
    recording["topics"].append(topic("/tf", [end("/robot_state_publisher", kind), end("/slam", kind)], []))
    recording["tf"]["/tf"][0]["publishers"] = {"writer_1": 50, "writer_2": 20}


@fault(
    "UC862",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="poses jump",
    authority="tf2 buffer_core.cpp: setTransform keeps what comes, whoever sent it; two sources of one transform alternate",
    bad=[example(_break)],
    good=[example()],
)
def transform_sent_twice(frame: str, parent: str, nodes: str) -> str:
    """Two nodes publish one transform.

    The frame jumps between both, for example between the odometry of a controller and that of a filter.
    """
    return f"two nodes publish the transform from '{parent}' to '{frame}'; on its topic publish {nodes}"
