"""UC429."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import SequenceMatcher

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import replaced
from urdfctl.rules.controllers.common import controllers_in

_RIGHT = "controller_manager"
_ALIKE = 0.93


@rule(
    "UC429",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="rclcpp: a section is read by the node whose name it is; ros2_control's node is controller_manager: 'The "
    "'type' param was not defined for 'arm'.'",
    options=["--distro=jazzy"],
    bad={
        "controllers.yaml": """
            «controllers_manager»:
              ros__parameters:
                update_rate: 100
                states: {type: joint_state_broadcaster/JointStateBroadcaster}
        """
    },
    good={
        "controllers.yaml": """
            controller_manager:
              ros__parameters:
                update_rate: 100
                states: {type: joint_state_broadcaster/JointStateBroadcaster}
        """
    },
)
def manager_name_misspelt(project: Project) -> Iterator[Finding]:
    """The section of the controller manager is misspelt.

    The node is called `controller_manager` unless it is started under another name, and reads no other section: neither
    its rate nor its controllers are known to it.
    """
    for manager in controllers_in(project).managers:
        name = manager.name
        alike = SequenceMatcher(None, name.casefold(), _RIGHT).ratio()
        if name != _RIGHT and alike >= _ALIKE:
            message = f"no node is called '{name}'; did you mean '{_RIGHT}'?"
            yield Finding(manager.at, message, fix=replaced(manager.at, name, _RIGHT))
