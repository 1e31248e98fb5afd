"""UC860."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["nodes"].append({"name": "controller_manager", "namespace": "/"})


@fault(
    "UC860",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="which one answers is chance",
    authority="rcl: 'Publisher already registered for provided node name'; services of two nodes with one name answer in turns",
    bad=[example(_break)],
    good=[example()],
)
def node_runs_twice(node: str) -> str:
    """Two nodes have one name.

    A launch file was started twice, or an old process still runs. Services and parameters of both answer in turns.
    """
    return f"two nodes are called {node}: one of them is left from an earlier start, or a launch file starts it twice"
