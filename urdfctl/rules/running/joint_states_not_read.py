"""UC843."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, topic


def _break(recording: Recorded) -> None:
    kind = "sensor_msgs/msg/JointState"
    recording["topics"][0]["subscriptions"] = []
    recording["topics"].append(topic("/robot/joint_states", [], [end("/robot/robot_state_publisher", kind)]))


@fault(
    "UC843",
    severity=Severity.ERROR,
    runtime="drops",
    authority="robot_state_publisher.cpp subscribes joint_states in its own namespace",
    bad=[example(_break)],
    good=[example()],
)
def joint_states_not_read(node: str, reads: str, published: str) -> str:
    """robot_state_publisher reads joint states that nobody publishes.

    The broadcaster publishes in the namespace of its manager. Start both in one namespace, or remap joint_states.
    """
    return f"{node} reads {reads}, which nobody publishes; the joint states are on {published}"
