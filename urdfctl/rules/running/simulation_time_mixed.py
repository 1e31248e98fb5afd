"""UC805."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, topic


def _break(recording: Recorded) -> None:
    recording["topics"].append(topic("/clock", [end("/bridge", "rosgraph_msgs/msg/Clock")], []))
    for node in ("/head", "/controller_manager", "/joint_state_broadcaster"):
        recording["parameters"][node]["values"]["use_sim_time"] = True


@fault(
    "UC805",
    severity=Severity.WARNING,
    runtime="misbehaves",
    authority="tf2 buffer_core.cpp: transforms stamped with another clock are in the past or the future: 'Lookup would require extrapolation'",
    bad=[example(_break)],
    good=[example()],
)
def simulation_time_mixed(node: str, others: str) -> str:
    """Node uses another clock than the others.

    Something publishes /clock, and only some nodes have use_sim_time true: their stamps do not fit.
    """
    return f"{node} has use_sim_time false, but {others} use the simulation's time; set it to true"
