"""UC428."""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in, is_of_ros2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.source.opaque import UNKNOWN

_IN_ROS1 = r"[A-Za-z0-9_]+"
_IN_ROS2 = r"[A-Za-z_][A-Za-z0-9_]*"


@rule(
    "UC428",
    severity=Severity.ERROR,
    runtime="refuses",
    authority="ros_control controller_manager.cpp: 'Exception thrown while constructing nodehandle for controller with "
    "name 'arm.left'' ; rmw: a node's name consists of letters, digits and underscores",
    options=["--distro=noetic"],
    bad=[
        {
            "controllers.yaml": """
                «arm-left»:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """
        },
    ],
    good=[
        {
            "controllers.yaml": """
                arm_left:
                  type: position_controllers/JointGroupPositionController
                  joints: [shoulder, elbow]
            """
        },
    ],
)
def controller_name_unusable(project: Project) -> Iterator[Finding]:
    """Invalid controller name.

    A controller's name becomes the name of a node and part of topic names: only letters, digits and underscores are
    allowed, and in ROS 2 no digit at the start. A controller with another name is not loaded.
    """
    for controller in controllers_in(project).controllers:
        name, at = controller.name, controller.declared_at
        of_ros2 = is_of_ros2(project, controller)
        if (
            at is None
            or re.fullmatch(_IN_ROS2 if of_ros2 else _IN_ROS1, name)
            or UNKNOWN in name
            or re.search(r"[${}<>%]", name)
        ):
            continue
        allowed = "letters, digits and underscores" + (", and no digit at the start" if of_ros2 else "")
        yield Finding(at, f"controller name '{name}' is invalid; use only {allowed}")
