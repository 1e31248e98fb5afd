"""UC651."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ROS2
from urdfctl.model.controllers import MoveItController
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.moveit.samples import configured
from urdfctl.source.span import SourceSpan

_ACTIONS = {"FollowJointTrajectory": "follow_joint_trajectory", "GripperCommand": "gripper_cmd"}


@rule(
    "UC651",
    severity=Severity.ERROR,
    distros=ROS2,
    authority="moveit2 moveit_simple_controller_manager.cpp: 'No action namespace specified for controller `arm_controller` "
    "through parameter', 'No type specified for controller', 'No joints specified for controller'",
    bad=configured(
        "  arm_controller:\n        type: FollowJointTrajectory\n        action_ns: follow_joint_trajectory",
        "  «arm_controller»:\n        type: FollowJointTrajectory",
    ),
    good=configured(),
)
def moveit_controller_incomplete(project: Project) -> Iterator[Finding]:
    """MoveIt is not told all of a controller that it needs to know.

    It leaves the controller out then, and cannot execute what it has planned: 'Unable to identify any set of controllers
    that can actuate the specified joints'. Needed are the type, the joints, and the namespace of the action, which
    the setup assistant leaves out.
    """
    for controller in project.controllers.moveit if project.controllers else ():
        if controller.section is None:
            name = controller.name
            yield Finding(name.at, f"MoveIt is told to use '{name.text}', and nothing describes it here")
        elif controller.lacking:
            what = in_words(controller.lacking)
            message = f"MoveIt leaves '{controller.section.text}' out: it is not told its {what}"
            yield Finding(controller.section.at, message, (), _fix(controller))


def _fix(controller: MoveItController) -> Fix | None:
    """The action namespace that controllers of a type have."""
    first, action = controller.first, _ACTIONS.get(controller.type or "")
    if controller.lacking != ("action_ns",) or first is None or action is None:
        return None
    source = first.source
    column = source.position(first.start).column
    text = f"action_ns: {action}\n{' ' * (column - 1)}"
    return Fix(f"add 'action_ns: {action}'", (Edit(SourceSpan(source, first.start, first.start), text),))
