"""UC802."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, silent_manager


def _break(recording: Recorded) -> None:
    silent_manager(recording)
    recording["topics"][2]["publishers"] = [end("/script", "std_msgs/msg/String", "volatile")]


@fault(
    "UC802",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: 'Waiting for data on 'robot_description' topic to finish initialization'; it subscribes transient_local",
    bad=[example(_break)],
    good=[example()],
)
def description_not_received(manager: str, topic: str, reason: str) -> str:
    """Controller manager waits for the robot description.

    It reads it from a topic, and offers its services only then. The publisher must keep the last message for late
    subscribers (durability transient_local), as robot_state_publisher does.
    """
    return f"controller manager '{manager}' waits for {topic}: {reason}"
