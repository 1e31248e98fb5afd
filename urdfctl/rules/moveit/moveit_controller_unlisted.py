"""UC675."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.moveit.samples import configured

_HAND = """
      hand_controller:
        type: GripperCommand
        action_ns: gripper_cmd
        joints: [elbow]
      arm_controller:"""
_LISTED = "\n      arm_controller:"


@rule(
    "UC675",
    severity=Severity.WARNING,
    runtime="drops",
    because="the section may be left over",
    distros=ROS2,
    authority="moveit_simple_controller_manager.cpp initialize(): only the controllers in controller_names are created",
    bad=[configured(_LISTED, _HAND.replace("hand_controller", "«hand_controller»"))],
    good=[configured()],
)
def moveit_controller_unlisted(project: Project) -> Iterator[Finding]:
    """Controller is described, but controller_names does not list it.

    MoveIt ignores the section, and does not execute plans for its joints.
    """
    for key in project.moveit.unlisted if project.moveit else ():
        yield Finding(key.at, f"MoveIt ignores controller '{key.text}': add it to controller_names")
