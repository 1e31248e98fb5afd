"""UC820."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import Recorded, example, manager_in


def _break(recording: Recorded) -> None:
    manager_in(recording)["list_hardware_components"]["component"][0]["state"]["label"] = "inactive"


@fault(
    "UC820",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros2_control controller_manager.cpp: controllers cannot be activated with interfaces of hardware that is not active",
    bad=[example(_break)],
    good=[example()],
)
def running_hardware_not_active(component: str, state: str, manager: str) -> str:
    """Hardware component is not active.

    Its states may still be published, but no controller that commands it can be activated. It was started so by
    hardware_components_initial_state, deactivated, or ended with an error.
    """
    how = f"ros2 control set_hardware_component_state -c {manager} {component} active"
    return f"hardware '{component}' is {state}, not active: nothing can command it; {how}"
