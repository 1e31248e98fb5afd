"""UC651."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.catalog.distros import ALL
from urdfctl.model.controllers import MoveItController
from urdfctl.rule import Edit, Finding, Fix, Project, Severity, rule
from urdfctl.rules.common import in_words
from urdfctl.rules.moveit.common import real_controllers
from urdfctl.rules.moveit.samples import configured
from urdfctl.source.span import SourceSpan

_ACTIONS = {"FollowJointTrajectory": "follow_joint_trajectory", "GripperCommand": "gripper_cmd"}


@rule(
    "UC651",
    severity=Severity.ERROR,
    runtime="drops",
    distros=ALL,
    authority="moveit2 moveit_simple_controller_manager.cpp: 'No action namespace specified for controller `arm_controller` "
    "through parameter', 'No type specified for controller', 'No joints specified for controller'; moveit: 'name, joints, "
    "action_ns, and type must be specifed for each controller'",
    bad=[
        configured(
            "  arm_controller:\n        type: FollowJointTrajectory\n        action_ns: follow_joint_trajectory",
            "  «arm_controller»:\n        type: FollowJointTrajectory",
        ),
        configured(
            "  arm_controller:\n        type: FollowJointTrajectory\n        action_ns: follow_joint_trajectory",
            "  «arm_controller»:\n        type: GripperCommand",
        ),
        configured(
            "  arm_controller:\n        type: FollowJointTrajectory\n        action_ns: follow_joint_trajectory",
            "  «arm_controller»:\n        default: true",
        ),
    ],
    good=[configured()],
)
def moveit_controller_incomplete(project: Project) -> Iterator[Finding]:
    """Incomplete controller in MoveIt's configuration.

    MoveIt ignores the controller, and cannot execute its plans: 'Unable to identify any set of controllers that can
    actuate the specified joints'. It requires the type, the joints and the action namespace. The setup assistant omits
    the last one.
    """
    for controller in real_controllers(project):
        if controller.section is None:
            name = controller.name
            yield Finding(name.at, f"controller_names lists '{name.text}', but this file does not describe it")
        elif project.ros == 1 and {"type", "action_ns"} <= set(controller.lacking):
            continue  # the list of another controller manager
        elif controller.lacking:
            is_or_are = "is" if len(controller.lacking) == 1 else "are"
            missing = f"{in_words(controller.lacking)} {is_or_are} missing"
            message = f"MoveIt ignores controller '{controller.section.text}': {missing}"
            yield Finding(controller.section.at, message, (), _fix(controller))


def _fix(controller: MoveItController) -> Fix | None:
    """Return the fix that adds a missing action namespace. None if the type has no usual one, or more is missing."""
    first, action = controller.first, _ACTIONS.get(controller.type or "")
    if controller.lacking != ("action_ns",) or first is None or action is None:
        return None
    source = first.source
    column = source.position(first.start).column
    text = f"action_ns: {action}\n{' ' * (column - 1)}"
    return Fix(f"add 'action_ns: {action}'", (Edit(SourceSpan(source, first.start, first.start), text),))
