"""UC665."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import in_words, is_known
from urdfctl.rules.moveit.common import is_of_other_robot, planning, real_controllers
from urdfctl.rules.moveit.samples import MOVEIT, planned


def _files(joints: str, mark: str) -> dict[str, str]:
    moveit = MOVEIT.replace("[shoulder, elbow]", joints)
    return planned('group name="arm"', f'group name="{mark}"', moveit_controllers=moveit)


@rule(
    "UC665",
    runtime="refuses",
    because="another file may give the controller",
    severity=Severity.WARNING,
    whole_robot=True,
    in_library=False,
    authority="moveit_ros_planning trajectory_execution_manager.cpp: 'Unable to identify any set of controllers that can actuate "
    "the specified joints: [ elbow shoulder ]'",
    bad=[_files("[elbow]", "«arm»")],
    good=[_files("[shoulder, elbow]", "arm")],
)
def group_without_controller(project: Project) -> Iterator[Finding]:
    """Planning group has joints without a controller in MoveIt's configuration.

    MoveIt plans for the group, and cannot execute the plan, because none of its controllers moves these joints.
    """
    groups, moveit = planning(project), project.moveit
    if groups is None or moveit is None or not moveit.controllers or moveit.guessed or is_of_other_robot(project):
        return
    moved = {joint.text for controller in moveit.controllers for joint in controller.joints}
    if not all(is_known(joint) and "$" not in joint for joint in moved) or any(
        one.lacking for one in real_controllers(project)
    ):
        return
    moved |= {joint.text for joint in groups.semantic.passive}
    reported: set[str] = set()
    for group in sorted(groups.semantic.groups, key=lambda each: len(groups.active(each))):
        missing = [joint for joint in groups.active(group) if joint not in moved]
        if not missing or set(missing) <= reported:
            continue
        reported |= set(missing)
        joints = f"joint{'s' * (len(missing) > 1)} {in_words(missing, 3)}"
        message = f"group '{group.name.text}' cannot be executed: no controller of MoveIt moves {joints}"
        severity = Severity.INFO if not set(groups.active(group)) & moved else None
        yield Finding(group.name.at, message, severity=severity)
