"""UC846."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["joint_states"]["/joint_states"]["stamps"] = ["7.5"] * 200


@fault(
    "UC846",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="transforms are not updated",
    authority="robot_state_publisher.cpp ignores joint states that are not newer; joint_state_broadcaster stamps each message with the time of update()",
    bad=[example(_break)],
    good=[example()],
)
def joint_states_stand_still(topic: str, stamp: str) -> str:
    """Joint states come with one stamp again and again.

    The time of the node that publishes them stands still, or it repeats an old message. robot_state_publisher ignores them.
    """
    return f"{topic} comes with the stamp {stamp} again and again: the clock of its publisher stands still"
