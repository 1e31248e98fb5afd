"""UC842."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example


def _break(recording: Recorded) -> None:
    recording["topics"][0]["publishers"].append(end("/joint_state_publisher", "sensor_msgs/msg/JointState"))
    recording["joint_states"]["/joint_states"]["publishers"] = {"writer_1": 200, "writer_2": 20}


@fault(
    "UC842",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="the robot's pose is wrong half of the time",
    authority="robot_state_publisher.cpp uses each message as it comes: the robot jumps between both",
    bad=[example(_break)],
    good=[example()],
)
def two_joint_state_publishers(topic: str, nodes: str) -> str:
    """Several nodes publish the same joint states.

    joint_state_publisher is for robots without a controller manager. The robot jumps between the values of both.
    """
    return f"{topic} is published by {nodes}, for the same joints; stop all but the broadcaster"
