"""UC844."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["joint_states"]["/joint_states"]["last"]["position"] = ["nan", 0.2]


@fault(
    "UC844",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="no transform of these links can be used",
    authority="mock_components and drivers export NaN until a value was set; robot_state_publisher passes it on to tf",
    bad=[example(_break)],
    good=[example()],
)
def joint_states_not_finite(topic: str, joints: str) -> str:
    """Joint states are no numbers.

    The hardware has not read them, or has no initial value.
    """
    return f"{topic} has no finite position for {joints}: the hardware does not report it"
