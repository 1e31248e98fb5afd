"""UC841."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["joint_states"]["/joint_states"]["name_lists"] = [["pan"]]


@fault(
    "UC841",
    severity=Severity.ERROR,
    runtime="drops",
    authority="joint_state_broadcaster.cpp: with 'joints' only these are published; robot_state_publisher gives no transform for others",
    bad=[example(_break)],
    good=[example()],
)
def joint_states_incomplete(topic: str, joints: str) -> str:
    """Joint states lack joints of the robot.

    The broadcaster lists only some joints, or the hardware exports no state of the others.
    """
    return f"{topic} lacks {joints}: the broadcaster does not publish them, and their links get no transform"
