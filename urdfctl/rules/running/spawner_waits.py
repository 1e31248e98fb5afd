"""UC807."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example


def _break(recording: Recorded) -> None:
    recording["nodes"].append({"name": "spawner_head", "namespace": "/"})
    recording["services"].append({"name": "/cell/controller_manager/list_controllers"})


@fault(
    "UC807",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="spawner.py: 'waiting for service ... to become available...'; the client alone makes the service's name appear",
    bad=[example(_break)],
    good=[example()],
)
def spawner_waits(spawner: str, manager: str, running: str) -> str:
    """Spawner waits for a controller manager that does not run.

    The manager has another name or namespace, or has ended. Its controllers are never loaded.
    """
    return f"{spawner} waits for {manager}, which does not run{running}"
