"""UC840."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["topics"][0]["publishers"] = []
    recording["joint_states"] = {}


@fault(
    "UC840",
    severity=Severity.ERROR,
    runtime="drops",
    authority="robot_state_publisher.cpp: transforms of moving joints come with joint_states only",
    bad=[example(_break)],
    good=[example()],
)
def no_joint_states(topic: str, broadcaster: str) -> str:
    """Nobody publishes the joint states.

    robot_state_publisher and planners wait for them. A joint_state_broadcaster publishes them while it is active.
    """
    return f"nobody publishes {topic}: spawn {broadcaster}; without it moving links have no transform"
