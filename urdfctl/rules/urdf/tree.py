"""The tree that a robot's joints make of its links, as urdfdom builds it."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.model.robot import Joint, Link, Robot

WORLD = "world"
"""The root link of this name is the ground that Gazebo fixes a robot to."""


class Tree:
    """Links by name, each with the joint that it is the child of: the last one where there are several."""

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
        """The links that no joint has as its child."""
        return [link for name, link in self.links.items() if name not in self.parents]

    def below(self, name: str) -> set[str]:
        """The names of a link and of all links below it."""
        found, pending = {name}, [name]
        while pending:
            for joint in self.children.get(pending.pop(), ()):
                child = child_of(joint)
                if child not in found:
                    found.add(child)
                    pending.append(child)
        return found

    def circles(self) -> Iterator[list[Joint]]:
        """The joints of each circle, from parents to children."""
        done: set[str] = set()
        for name in self.links:
            way: dict[str, Joint] = {}
            step = name
            while step in self.parents and step not in way and step not in done:
                way[step] = self.parents[step]
                step = parent_of(way[step])
            if step in way:
                joints = list(way.values())[list(way).index(step) :]
                yield joints[::-1]
            done.update(way)


def parent_of(joint: Joint) -> str:
    """The name of a joint's parent link; empty where there is none."""
    return (joint.parent.name if joint.parent else None) or ""


def child_of(joint: Joint) -> str:
    """The name of a joint's child link; empty where there is none."""
    return (joint.child.name if joint.child else None) or ""
