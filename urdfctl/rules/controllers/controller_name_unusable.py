"""UC428."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.controllers.common import controllers_in
from urdfctl.rules.controllers.readers import is_of_ros2
from urdfctl.source.opaque import UNKNOWN

_IN_ROS1 = r"[A-Za-z0-9_]+"
_IN_ROS2 = r"[A-Za-z_][A-Za-z0-9_]*"


@rule(
    "UC428",
    severity=Severity.ERROR,
    authority="ros_control controller_manager.cpp: 'Exception thrown while constructing nodehandle for controller with "
    "name 'arm.left'' ; rmw: a node's name holds letters, digits and underscores",
    options=["--distro=noetic"],
    bad={
        "controllers.yaml": """
            «arm-left»:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
        """
    },
    good={
        "controllers.yaml": """
            arm_left:
              type: position_controllers/JointGroupPositionController
              joints: [shoulder, elbow]
        """
    },
)
def controller_name_unusable(project: Project) -> Iterator[Finding]:
    """A controller's name can be no name of a node.

    Names of controllers become names of nodes and topics: letters, digits and underscores. A controller that is called
    otherwise is not loaded.
    """
    for controller in controllers_in(project).controllers:
        name, at = controller.name, controller.declared_at
        right = _IN_ROS2 if is_of_ros2(project, controller) else _IN_ROS1
        if at is None or re.fullmatch(right, name) or UNKNOWN in name or re.search(r"[${}<>%]", name):
            continue
        yield Finding(at, f"'{name}' is no name for a controller: only letters, digits and underscores are")
