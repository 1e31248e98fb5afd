"""UC661."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.rule import Finding, Note, Project, Severity, rule
from urdfctl.rules.moveit.samples import planned


@rule(
    "UC661",
    severity=Severity.WARNING,
    runtime="warns",
    authority='srdfdom src/model.cpp: "Group \'wrist\' is empty."; moveit_core robot_model.cpp addJointModelGroup(): "Group '
    "'wrist' must have at least one valid joint\", \"A group named 'arm' already exists. Not adding.\"",
    bad=[planned('<group name="wrist"><joint name="elbow"/></group>', '<group name="«wrist»"/>')],
    good=[planned()],
)
def semantic_group_unusable(project: Project) -> Iterator[Finding]:
    """Planning group is empty, or defined twice.

    MoveIt prints a warning, does not create a group without joints, and ignores the second group of the same name.
    """
    semantic = project.moveit.semantic if project.moveit else None
    if semantic is None or not semantic.complete:
        return
    for group in semantic.groups:
        name = group.name.text
        first = semantic.group(name)
        if group.is_empty:
            yield Finding(group.name.at, f"group '{name}' is empty; list its joints, or remove it")
        elif first is not None and first is not group:
            notes = (Note("the first one is here", first.name.at),)
            yield Finding(group.name.at, f"group '{name}' is defined twice; MoveIt ignores this one", notes)
