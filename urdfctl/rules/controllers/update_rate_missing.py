"""UC426."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import until
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Project, Severity, rule


@rule(
    "UC426",
    severity=Severity.INFO,
    runtime="works",
    distros=until("iron"),
    authority="ros2_control controller_manager/src/controller_manager.cpp: ''update_rate' parameter not set, using "
    "default value.'",
    options=["--distro=humble"],
    bad=[
        {
            "controllers.yaml": """
                «controller_manager»:
                  ros__parameters:
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    joint_states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
    ],
)
def update_rate_missing(project: Project) -> Iterator[Finding]:
    """Controller manager without an update rate.

    It runs at 100 Hz, and up to iron prints a message about it. From jazzy on, 100 Hz is the documented default.
    """
    controllers = controllers_in(project)
    if not controllers.complete:
        return
    for manager in controllers.managers:
        if manager.own and "update_rate" not in manager.parameters:
            yield Finding(manager.at, f"'{manager.name}' has no 'update_rate'; it runs at 100 Hz")
