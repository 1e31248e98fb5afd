"""Links and joints that were renamed: at the same place in the tree of the robot, under another name."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfctl.compare.tree import TreeNode, is_same
from urdfctl.startup.records import NamedTuple

_ALIKE = 0.75
"""From this share of equal values on, a joint of another name counts as the same joint."""
_OF_LINKS = {("parent", "link"), ("child", "link")}


class RenamedParts(NamedTuple):
    """The old and the new names of what was renamed."""

    links: Mapping[str, str]
    joints: Mapping[str, str]

    def of(self, tag: str, attribute: str, text: str) -> str:
        """Return a text of the old robot with the new name, if it is the name of something that was renamed."""
        if not self.links and not self.joints:
            return text
        if (tag, attribute) in _OF_LINKS or tag == "link":
            return self.links.get(text, text)
        names = {**self.links, **self.joints}
        return re.sub(r'[^\s"\[\],]+', lambda word: names.get(word[0], word[0]), text)


class _NamedTree:
    """The links and joints of a robot by name, and the joints below each link."""

    def __init__(self, robot: TreeNode) -> None:
        self.links = {node.key: node for node in robot.children if node.tag == "link" and node.key}
        self.joints = {node.key: node for node in robot.children if node.tag == "joint" and node.key}
        self.below: dict[str, list[TreeNode]] = {}
        children = set()
        for joint in self.joints.values():
            self.below.setdefault(end(joint, "parent"), []).append(joint)
            children.add(end(joint, "child"))
        self.roots = [name for name in self.links if name not in children]


def end(joint: TreeNode, role: str) -> str:
    """Return the name of the parent or child link of a joint; empty if it has none."""
    return next((child.values.get("link", "") for child in joint.children if child.tag == role), "")


def renamed(before: TreeNode, after: TreeNode) -> RenamedParts:
    """Return what was renamed from one robot to another."""
    old, new = _NamedTree(before), _NamedTree(after)
    links: dict[str, str] = {}
    joints: dict[str, str] = {}
    gone, come = [one for one in old.roots if one not in new.links], [one for one in new.roots if one not in old.links]
    if len(old.roots) == len(new.roots) == len(gone) == len(come) == 1:
        links[gone[0]] = come[0]
    pending = [(name, name) for name in old.links if name in new.links] + list(links.items())
    for link, other in pending:
        for joint, same in _pairs(old, new, old.below.get(link, ()), new.below.get(other, ())):
            if joint.key != same.key:
                joints[joint.key] = same.key
            child, other_child = end(joint, "child"), end(same, "child")
            is_new = child in old.links and child not in new.links and child not in links
            if is_new and other_child in new.links and other_child not in old.links:
                links[child] = other_child
                pending.append((child, other_child))
    return RenamedParts(links, joints)


def _pairs(
    old: _NamedTree, new: _NamedTree, before: list[TreeNode] | tuple[()], after: list[TreeNode] | tuple[()]
) -> Iterator[tuple[TreeNode, TreeNode]]:
    """Yield the joints below a link that are the same: by name, or else by what they are."""
    by_name = {joint.key: joint for joint in after}
    yield from ((joint, by_name[joint.key]) for joint in before if joint.key in by_name)
    gone = [joint for joint in before if joint.key not in new.joints]
    come = [joint for joint in after if joint.key not in old.joints]
    for joint in gone:
        best = max(come, key=lambda other: _likeness(joint, other), default=None)
        if best is not None and _likeness(joint, best) >= _ALIKE:
            come.remove(best)
            yield joint, best


def _likeness(joint: TreeNode, other: TreeNode) -> float:
    """The share of values, from 0 to 1, in which two joints agree; 1 if they move the same link."""
    if end(joint, "child") == end(other, "child"):
        return 1.0
    left, right = dict(_values(joint)), dict(_values(other))
    same = sum(name in right and is_same(value, right[name]) for name, value in left.items())
    return same / max(len(left.keys() | right.keys()), 1)


def _values(joint: TreeNode) -> Iterator[tuple[tuple[str, str], str]]:
    yield ("", "type"), joint.values.get("type", "")
    for child in joint.children:
        if child.tag not in {"parent", "child"}:
            yield from (((child.tag, name), value) for name, value in child.values.items())
