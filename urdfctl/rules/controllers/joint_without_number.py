"""UC425."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.control.parameters.readers import controllers_in
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.source.span import Place

_ARM = """
    controller_manager:
      ros__parameters:
        update_rate: 100
        arm: {type: forward_command_controller/ForwardCommandController}
        hold: {type: forward_command_controller/ForwardCommandController}
    arm: {ros__parameters: {joints: [arm_joint1, arm_joint2], interface_name: position}}
    hold: {ros__parameters: {joints: [%s], interface_name: velocity}}
"""


@rule(
    "UC425",
    runtime="refuses",
    because="no robot is known: the name only looks misspelt",
    severity=Severity.WARNING,
    authority="controller_interface: a controller is not activated if a claimed interface is 'not available' (ROS 2), and "
    "not loaded on 'Could not find joint' (ROS 1)",
    bad=[{"controllers.yaml": _ARM % "«arm_joint»"}],
    good=[{"controllers.yaml": _ARM % "arm_joint1"}],
)
def joint_without_number(project: Project) -> Iterator[Finding]:
    """Joint name without a number among numbered joints.

    A robot with joints `arm_joint1` and `arm_joint2` is unlikely to have a joint `arm_joint` too. Checked only if no
    robot is known.
    """
    joints = list(_joints(project)) if project.robot is None else []
    names = {name for name, _ in joints}
    for name, at in joints:
        numbered = sorted(other for other in names if other.startswith(name) and other[len(name) :].isdigit())
        if len(numbered) > 1:
            message = f"joint '{name}' has no number, unlike {in_words(numbered)} in the other controllers"
            yield Finding(at, message)


def _joints(project: Project) -> Iterator[tuple[str, Place]]:
    for controller in controllers_in(project).controllers:
        for parameter in ("joint", "joints"):
            value = controller.own.value(parameter)
            if value is not None and value.is_known:
                yield from ((name, at) for name, at in value.strings if name)
