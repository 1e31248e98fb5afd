"""UC811."""

from __future__ import annotations

from urdfctl.fault import Severity, fault
from urdfctl.rules.running.samples import DESCRIPTION, Recorded, example


def _break(recording: Recorded) -> None:
    mock = DESCRIPTION.replace("arm_driver/ArmSystem", "mock_components/GenericSystem")
    recording["robot_description"]["/robot_description"] = [{"data": mock}]


@fault(
    "UC811",
    severity=Severity.ERROR,
    runtime="misbehaves",
    because="the robot does not move",
    authority="hardware_info.hpp: the manager loads the plugin that the description names",
    bad=[example(_break)],
    good=[example()],
)
def running_hardware_differs(component: str, running: str, files: str) -> str:
    """Hardware that is running is not that of the files.

    With mock hardware everything is active and nothing moves. Rebuild and source the workspace, or look at the launch
    arguments that choose the hardware.
    """
    return f"the running description has hardware plugin '{running}' for '{component}', the files have '{files}'"
