"""UC429."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.control.parameters.readers import controllers_in
from urdfctl.names import is_alike
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced

_RIGHT = "controller_manager"
_ALIKE = 0.93


@rule(
    "UC429",
    runtime="drops",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rclcpp: a node reads the section with its name; ros2_control's node is controller_manager: 'The "
    "'type' param was not defined for 'arm'.'",
    options=["--distro=jazzy"],
    bad=[
        {
            "controllers.yaml": """
                «controllers_manager»:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                controller_manager:
                  ros__parameters:
                    update_rate: 100
                    states: {type: joint_state_broadcaster/JointStateBroadcaster}
            """
        },
    ],
)
def manager_name_misspelt(project: Project) -> Iterator[Finding]:
    """Misspelt section name of the controller manager.

    The node is called `controller_manager` unless it is started under another name. It reads only the section with its
    own name, so it gets neither the update rate nor the controllers given here.
    """
    for manager in controllers_in(project).managers:
        name = manager.name
        if name != _RIGHT and is_alike(name.casefold(), _RIGHT, _ALIKE):
            message = f"section '{name}' matches no node; did you mean '{_RIGHT}'?"
            yield Finding(manager.at, message, fix=replaced(manager.at, name, _RIGHT))
