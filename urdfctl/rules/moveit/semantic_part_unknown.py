"""UC658."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Key
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, replaced
from urdfctl.rules.moveit.common import is_of_other_robot, joints_in, links_in, planning
from urdfctl.rules.moveit.samples import planned


@rule(
    "UC658",
    severity=Severity.ERROR,
    runtime="drops",
    whole_robot=True,
    in_library=False,
    authority="srdfdom src/model.cpp loadGroups(): \"Joint 'elbow' declared as part of group 'arm' is not known to the URDF\", "
    "\"Link 'fore' declared as part of a chain in group 'arm' is not known to the URDF\"; loadGroupStates(), "
    "loadEndEffectors(), loadVirtualJoints(), loadPassiveJoints()",
    bad=[planned('tip_link="fore"', 'tip_link="«forearm»"')],
    good=[planned()],
)
def semantic_part_unknown(project: Project) -> Iterator[Finding]:
    """SRDF names an unknown link or joint.

    MoveIt reports it and leaves it out. A group without it plans for other joints, and a group of which nothing is left
    does not exist.
    """
    groups = planning(project)
    if groups is None or is_of_other_robot(project):
        return
    joints = {*groups.joints, *groups.virtual}
    yield from _unknown("link", links_in(groups.semantic), groups.links)
    yield from _unknown("joint", joints_in(groups.semantic), joints)


def _unknown(kind: str, named: Iterator[tuple[str, Key]], known: set[str]) -> Iterator[Finding]:
    names = KnownNames(known)
    for what, key in named:
        if key.text in names or not is_known(key.text):
            continue
        meant = names.meant_by(key.text)
        hint = f"; did you mean '{meant}'?" if meant else ""
        fix = replaced(key.at, key.text, meant) if meant else None
        message = f"{what} names {kind} '{key.text}', which the robot does not have{hint}"
        severity = Severity.WARNING if what.startswith(("state", "<passive")) else None
        yield Finding(key.at, message, (), fix, severity)
