"""UC660."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.controllers import Key
from urdfctl.model.moveit import Semantic
from urdfctl.rule import Finding, Project, Severity, rule
from urdfctl.rules.common import KnownNames, is_known, replaced
from urdfctl.rules.moveit.samples import planned


@rule(
    "UC660",
    runtime="drops",
    severity=Severity.ERROR,
    authority="srdfdom src/model.cpp: \"Group 'arms' has unsatisfied subgroups\", \"Group state 'home' specified for group 'ar', "
    "but that group is not known\", \"End effector 'hand' specified for group 'grip', but that group is not known\"",
    bad=[planned('group="arm"', 'group="«arn»"')],
    good=[planned()],
)
def semantic_group_unknown(project: Project) -> Iterator[Finding]:
    """SRDF refers to an unknown group.

    MoveIt drops a group with an unknown subgroup, and a named state or an end effector of an unknown group.
    """
    semantic = project.moveit.semantic if project.moveit else None
    if semantic is None or not semantic.complete:
        return
    names = KnownNames(group.name.text for group in semantic.groups)
    for what, key in _named(semantic):
        if key.text in names or not is_known(key.text):
            continue
        meant = names.meant_by(key.text)
        hint = f"; did you mean '{meant}'?" if meant else ""
        fix = replaced(key.at, key.text, meant) if meant else None
        severity = None if what.startswith("group") else Severity.WARNING
        message = f"{what} refers to group '{key.text}', which the SRDF does not define{hint}"
        yield Finding(key.at, message, (), fix, severity)


def _named(semantic: Semantic) -> Iterator[tuple[str, Key]]:
    for group in semantic.groups:
        for inner in group.groups:
            yield f"group '{group.name.text}'", inner
    for state in semantic.states:
        if state.group is not None:
            yield f"state '{state.name}'", state.group
    for effector in semantic.effectors:
        for key in (effector.group, effector.parent_group):
            if key is not None:
                yield f"end effector '{effector.name}'", key
