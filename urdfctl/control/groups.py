"""The joints of MoveIt's planning groups, as moveit_core's robot_model.cpp and joint_model_group.cpp find them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from urdfctl.model.moveit import Chain, Group, Semantic, VirtualJoint
from urdfctl.model.robot import PartReference, Robot

_ROOT = ""
"""The joint above the root link, which every robot model has: a virtual joint, or a fixed one."""
_MOST_DEPTH = 100
_SHAPES = ("visual", "collision")
_MOVING = ("revolute", "continuous", "prismatic", "planar", "floating")


class Groups:
    """The planning groups of a robot.

    robot: the whole robot.
    semantic: its SRDF.
    """

    def __init__(self, robot: Robot, semantic: Semantic) -> None:
        self.semantic = semantic
        self.joints = {joint.name: joint for joint in robot.joints if joint.name}
        self.links = {link.name for link in robot.links if link.name}
        self._above = {name: joint.name for joint in robot.joints if joint.name and (name := _name_of(joint.child))}
        children = set(self._above)
        self.root = next((link.name for link in robot.links if link.name and link.name not in children), None)
        self.virtual = {joint.name.text: joint for joint in semantic.virtual if joint.name}
        top = robot.link(self.root) if self.root else None
        self._is_dummy = (
            self.root == "world" and top is not None and not any(child.name in _SHAPES for child in top.tag.children)
        )
        self._at_root = next((one for one in semantic.virtual if self.is_at_root(one)), None)
        self._members: dict[str, frozenset[str]] = {}
        self._depths: dict[str, int] = {}

    def path_up(self, link: str) -> Iterator[str]:
        """Yield the names of a link and of the links above it."""
        seen: set[str] = set()
        current: str | None = link
        while current is not None and current not in seen:
            seen.add(current)
            yield current
            joint = self.joints.get(self._above.get(current) or _ROOT)
            current = _name_of(joint.parent) if joint else None

    def is_at_root(self, virtual: VirtualJoint) -> bool:
        """Return whether MoveIt uses a virtual joint: it is at the root link, or fixed below an empty link `world`."""
        if virtual.child is None:
            return False
        return virtual.child.text == self.root or (self._is_dummy and virtual.type == "fixed")

    def joins(self, chain: Chain) -> bool:
        """Return whether a path leads from one link of a chain to the other. False if one of them is unknown."""
        if chain.base is None or chain.tip is None or not {chain.base.text, chain.tip.text} <= self.links:
            return False
        return bool(set(self.path_up(chain.base.text)) & set(self.path_up(chain.tip.text)))

    def members(self, group: Group, depth: int = 0) -> frozenset[str]:
        """Return the names of a group's joints, also fixed ones; an empty name is the joint above the root link."""
        name = group.name.text
        if depth > _MOST_DEPTH:
            return frozenset()
        if name not in self._members:
            self._members[name] = frozenset()  # for a group that contains itself
            found = {joint.text for joint in group.joints if joint.text in self.joints}
            if self._at_root and self._at_root.name and self._at_root.name.text in {one.text for one in group.joints}:
                found.add(_ROOT)
            found |= {self._above.get(link.text, _ROOT) for link in group.links if link.text in self.links}
            for chain in group.chains:
                found |= self._between(chain)
            for inner in group.groups:
                other = self.semantic.group(inner.text)
                found |= self.members(other, depth + 1) if other is not None else frozenset()
            self._members[name] = frozenset(found)
        return self._members[name]

    def active(self, group: Group) -> list[str]:
        """Return the joints of a group that move on their own, without mimic and virtual joints."""
        return sorted(name for name in self.members(group) if name and self._is_active(name))

    def is_chain(self, group: Group) -> bool:
        """Return whether a group is a chain: each of its joints is right below the one before it."""
        names = sorted(self.members(group), key=self._depth)
        active = {name for name in names if self._is_active(name)}
        roots = [name for name in active if not any(above in active for above in self._joints_above(name))]
        if len(roots) != 1:
            return False
        return all(self._is_below(after, before) for before, after in pairwise(names))

    # -- joints ------------------------------------------------------------------------------------------------------

    def _between(self, chain: Chain) -> set[str]:
        """The joints of a chain: from both links up to the first link that their paths share."""
        if not self.joins(chain) or chain.base is None or chain.tip is None:
            return set()
        up, other = list(self.path_up(chain.tip.text)), list(self.path_up(chain.base.text))
        known = set(other)
        shared = next(link for link in up if link in known)
        links = [*up[: up.index(shared)], *other[: other.index(shared)]]
        return {self._above.get(link, _ROOT) for link in links}

    def _joints_above(self, name: str) -> Iterator[str]:
        parent = _name_of(self.joints[name].parent) if name in self.joints else None
        for link in self.path_up(parent) if parent else ():
            yield self._above.get(link, _ROOT)

    def _is_below(self, name: str, other: str) -> bool:
        """Whether only fixed joints are between a joint and another one above it."""
        for above in self._joints_above(name):
            if above == other:
                return True
            joint = self.joints.get(above)
            if joint is None or joint.type != "fixed":
                return False
        return False

    def _depth(self, name: str) -> int:
        """The number of joints above a joint, with the one above the root link."""
        if name not in self._depths:
            above = [name, *self._joints_above(name)]
            known = next((index for index, each in enumerate(above) if each in self._depths), len(above))
            start = self._depths[above[known]] + 1 if known < len(above) else 0
            self._depths.update((each, start + index) for index, each in enumerate(reversed(above[:known])))
        return self._depths[name]

    def _is_active(self, name: str) -> bool:
        if name == _ROOT:
            return self._at_root is not None and self._at_root.type in _MOVING
        joint = self.joints.get(name)
        return joint is not None and joint.type in _MOVING and joint.mimic is None


def _name_of(reference: PartReference | None) -> str | None:
    return reference.name if reference else None
