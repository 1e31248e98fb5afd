"""UC808."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, controllers_in, example


def _break(recording: Recorded) -> None:
    controllers_in(recording).clear()
    values = recording["parameters"]["/controller_manager"]["values"]
    for name in [name for name in values if name.endswith(".type")]:
        del values[name]


@fault(
    "UC808",
    severity=Severity.ERROR,
    runtime="refuses",
    authority=(
        "controller_manager.cpp load_controller(): the type is the manager's parameter '<name>.type'; "
        "get_cm_node_options() declares each parameter that the node is started with"
    ),
    bad=[example(_break)],
    good=[example()],
)
def manager_without_types(manager: str, controllers: str) -> str:
    """Running controller manager knows the type of none of its controllers.

    It was started without the files' parameters: the file is missing in the node's `parameters`, its section has
    another name or namespace, or the spawner has not handed it over yet. It can load no controller.
    """
    return (
        f"controller manager '{manager}' has no '<name>.type' parameter for {controllers}, as the files have: it runs "
        "without their parameter file, or in another namespace than the file's section"
    )
