"""The nodes that contain a controller manager, and those that do not."""

from __future__ import annotations

import re

from urdfctl.model.launch import Node
from urdfctl.source.opaque import UNKNOWN

MANAGER = "ros2_control_node"
CONTROLLER_MANAGER = "controller_manager"
_OF_TRANSFORMS = ("robot_state_publisher", "state_publisher")
_CLIENTS = frozenset({CONTROLLER_MANAGER, "rqt_controller_manager", "moveit_ros_control_interface", "joy"})
"""Packages with a name like that of a manager, whose nodes only ask one."""
_HOST = re.compile(
    r"controller_manager|ros2?_control(?!ler)|hardware|driver|(^|_)hw(_|$)|control_(node|loop)$|(?<!move)_base$|"
    r"^(.*_)?(robot|base)_(node|main|interface)$|" + UNKNOWN
)
"""What the package or the program of a driver is called that contains a controller manager."""
_SCRIPTS = (".py", ".sh", ".bash")


def state_publisher(node: Node) -> bool:
    """Return whether a node publishes the robot's transforms and description."""
    return node.runs("robot_state_publisher", *_OF_TRANSFORMS)


def hosts_no_manager(node: Node) -> bool:
    """Return whether a node contains no controller manager. Drivers of hardware do, which have names like that."""
    if node.package.text in _CLIENTS or state_publisher(node) or node.executable.text.endswith(_SCRIPTS):
        return not node.runs(CONTROLLER_MANAGER, MANAGER)
    return not (_HOST.search(node.package.text) or _HOST.search(node.executable.text))
