"""UC804."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, end, example, topic


def _break(recording: Recorded) -> None:
    for values in recording["parameters"].values():
        values["values"]["use_sim_time"] = True


def _pause(recording: Recorded) -> None:
    _break(recording)
    recording["topics"].append(topic("/clock", [end("/bridge", "rosgraph_msgs/msg/Clock")], []))
    recording["clock"] = {"count": 200, "first": "7.0", "last": "7.0"}


@fault(
    "UC804",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="rclcpp time_source.cpp: with use_sim_time the time is 0 until a message on /clock arrives; controller_manager waits for it to switch controllers",
    bad=[example(_break), example(_pause)],
    good=[example()],
)
def clock_stands_still(state: str, nodes: str) -> str:
    """Nodes wait for a simulation time that nobody publishes.

    With use_sim_time true a node's clock stands still until /clock is published. Controllers are not switched, and
    nothing is published.
    """
    return (
        f"/clock {state}, but use_sim_time is true in {nodes}: start the simulator and its bridge, or set it to false"
    )
