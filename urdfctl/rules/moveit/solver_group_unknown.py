"""UC663."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, in_words, is_known, replaced
from urdfctl.rules.moveit.samples import KINEMATICS, planned


@rule(
    "UC663",
    severity=Severity.WARNING,
    runtime="ignores",
    authority="moveit_ros_planning robot_model_loader.cpp loadKinematicsSolvers(): a group in kinematics.yaml that is not in the "
    "SRDF is skipped; 'No kinematics plugins defined. Fill and load kinematics.yaml!'",
    bad=[planned(kinematics=KINEMATICS.replace("    arm:", "    «manipulator»:"))],
    good=[planned(kinematics=KINEMATICS)],
)
def solver_group_unknown(project: Project) -> Iterator[Finding]:
    """kinematics.yaml names an unknown group.

    MoveIt skips the entry without a message. The group that was meant has no inverse kinematics, and goals for its tip
    fail.
    """
    moveit = project.moveit
    semantic = moveit.semantic if moveit else None
    if moveit is None or semantic is None or not semantic.complete or not semantic.groups:
        return
    known = [group.name.text for group in semantic.groups]
    names = KnownNames(known)
    for solver in moveit.solvers:
        group = solver.group
        if solver.solver is None or group.text in names or not is_known(group.text):
            continue
        meant = names.meant_by(group.text)
        hint = f"did you mean '{meant}'?" if meant else f"its groups: {in_words(known)}"
        fix = replaced(group.at, group.text, meant) if meant else None
        message = f"kinematics.yaml names group '{group.text}', which the SRDF does not define; {hint}"
        yield Finding(group.at, message, (), fix)
