"""The planning groups of a robot, their named poses and the links that need no test, for its page in 3-D."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from urdfctl.control.groups import Groups
from urdfctl.model.project import Project
from urdfctl.model.robot import Tag


def planning_of(project: Project) -> dict[str, Any]:
    """Return the groups with their joints, the poses with their positions in rad or m, and pairs, as plain data.

    untested: for each link those that are not tested for collisions with it, each with the reason.

    There are none unless a launch file gives an SRDF to MoveIt, or one of the files is the SRDF of the robot.
    """
    semantic = project.moveit.semantic if project.moveit else None
    if semantic is None or project.robot is None:
        return {"groups": [], "poses": [], "untested": {}}
    groups = Groups(project.robot, semantic)
    named = [{"name": group.name.text, "joints": groups.active(group)} for group in semantic.groups]
    poses = [*_poses(semantic.tag, set(project.robot.joint_names))] if semantic.tag else []
    links = {link.name for link in project.robot.links if link.name}
    untested = _untested(semantic.tag, links) if semantic.tag else {}
    return {"groups": [group for group in named if group["joints"]], "poses": poses, "untested": untested}


def _untested(root: Tag, links: set[str]) -> dict[str, list[tuple[str, str]]]:
    found: dict[str, list[tuple[str, str]]] = {}
    for pair in root.named("disable_collisions"):
        one, other, reason = (pair.attributes.get(name, "") for name in ("link1", "link2", "reason"))
        if one in links and other in links:
            found.setdefault(one, []).append((other, reason))
            found.setdefault(other, []).append((one, reason))
    return dict(sorted(found.items()))


def _poses(root: Tag, known: set[str]) -> Iterator[dict[str, Any]]:
    for state in root.named("group_state"):
        given = {joint.attributes.get("name", ""): joint.attributes.get("value", "") for joint in state.named("joint")}
        values = {name: _number(text) for name, text in given.items() if name in known}
        positions = {name: value for name, value in values.items() if value is not None}
        if positions:
            name = f"{state.attributes.get('group', '')}: {state.attributes.get('name', '')}"
            yield {"name": name, "positions": positions}


def _number(text: str) -> float | None:
    """The first number of a text; None if it is not finite."""
    try:
        value = float(text.split(maxsplit=1)[0])
    except (ValueError, IndexError):
        return None
    return value if math.isfinite(value) else None
