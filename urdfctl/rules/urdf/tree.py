"""The tree of a robot's links and joints, as urdfdom builds it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint, Link, Robot

WORLD = "world"
"""Gazebo treats a root link of this name as the ground."""


class Tree:
    """The links by name, each with its parent joint (the last one, if there are several) and child joints."""

    def __init__(self, robot: Robot) -> None:
        self.links: dict[str, Link] = {}
        for link in robot.links:
            self.links.setdefault(link.name or "", link)
        self.parents: dict[str, Joint] = {}
        self.children: dict[str, list[Joint]] = {}
        self.has_unknown_ends = False
        for joint in robot.joints:
            parent, child = parent_of(joint), child_of(joint)
            if parent not in self.links or child not in self.links or not parent or not child:
                self.has_unknown_ends = True
                continue
            self.parents[child] = joint
            self.children.setdefault(parent, []).append(joint)

    @property
    def roots(self) -> list[Link]:
        """Return the links that are not the child of any joint."""
        return [link for name, link in self.links.items() if name not in self.parents]

    def below(self, name: str) -> set[str]:
        """Return the names of a link and of all links below it."""
        names, pending = {name}, [name]
        while pending:
            for joint in self.children.get(pending.pop(), ()):
                child = child_of(joint)
                if child not in names:
                    names.add(child)
                    pending.append(child)
        return names

    def circles(self) -> Iterator[list[Joint]]:
        """Yield the joints of each loop, from parents to children."""
        done: set[str] = set()
        for name in self.links:
            path: dict[str, Joint] = {}
            step = name
            while step in self.parents and step not in path and step not in done:
                path[step] = self.parents[step]
                step = parent_of(path[step])
            if step in path:
                joints = list(path.values())[list(path).index(step) :]
                yield joints[::-1]
            done.update(path)


def parent_of(joint: Joint) -> str:
    """Return the name of a joint's parent link; empty if it has none."""
    return (joint.parent.name if joint.parent else None) or ""


def child_of(joint: Joint) -> str:
    """Return the name of a joint's child link; empty if it has none."""
    return (joint.child.name if joint.child else None) or ""
