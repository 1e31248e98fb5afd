"""The bodies that Gazebo makes of a robot: sdformat lumps links with fixed joints, and drops bodies without mass."""

from __future__ import annotations

from urdfctl.model.robot import Inertial, Joint, Link, Robot
from urdfctl.rules.urdf.tree import WORLD, Tree, parent_of
from urdfctl.startup.records import NamedTuple

LEAST_MASS = 1e-6
"""In kg; sdformat treats smaller masses as none."""
_YES = ("true", "yes", "1")


class Body(NamedTuple):
    """Links that move as one."""

    head: Link
    """The link into which the others are lumped."""
    joint: Joint | None
    """The joint that connects the head to another body; None for a root."""
    links: list[Link]
    """All links of the body, including the head."""
    lost: int
    """How many moving joints disappear with the body: its own and those below it."""

    @property
    def is_weightless(self) -> bool:
        """Return whether sdformat finds no mass in the body."""
        return all(mass_of(link) <= LEAST_MASS for link in self.links)


def inertial_of(link: Link) -> Inertial | None:
    """Return the `<inertial>` that is read: the first one."""
    return link.inertials[0] if link.inertials else None


def mass_of(link: Link) -> float:
    """Return the absolute mass of a link in kg; 0 if it cannot be read. UC135 reports negative masses."""
    inertial = inertial_of(link)
    mass = inertial.mass.value if inertial and inertial.mass else None
    return abs(mass) if mass is not None else 0.0


def bodies(robot: Robot) -> list[Body]:
    """Return the bodies of a robot, each before those below it."""
    tree, kept = Tree(robot), _kept_joints(robot)
    heads: dict[str, str] = {}
    joints: dict[str, Joint | None] = {}
    members: dict[str, list[Link]] = {}
    pending = [link.name or "" for link in tree.roots]
    while pending:
        name = pending.pop()
        if name in heads:
            continue
        joint = tree.parents.get(name)
        above = parent_of(joint) if joint else ""
        lumped = joint is not None and joint.type == "fixed" and joint.name not in kept and above != WORLD
        heads[name] = heads.get(above, name) if lumped else name
        if heads[name] == name:
            joints[name] = joint
        members.setdefault(heads[name], []).append(tree.links[name])
        pending += [child.child.name for child in tree.children.get(name, ()) if child.child and child.child.name]
    lost = {head: int(joint.moves) if joint else 0 for head, joint in joints.items()}
    for head, joint in reversed(joints.items()):
        if joint is not None:
            lost[heads[parent_of(joint)]] += lost[head]
    return [Body(tree.links[head], joint, members[head], lost[head]) for head, joint in joints.items()]


def vanishing(robot: Robot) -> list[Body]:
    """Return the massless bodies that Gazebo drops, if they have moving joints or a fixed joint that is kept."""
    return [
        body
        for body in bodies(robot)
        if body.is_weightless
        and (body.lost or (body.joint is not None and parent_of(body.joint) != WORLD))
        and body.head.name != WORLD
    ]


def _kept_joints(robot: Robot) -> set[str]:
    """The fixed joints that a `<gazebo reference="...">` keeps."""
    kept = set()
    for gazebo in robot.gazebos:
        for name in ("preserveFixedJoint", "disableFixedJointLumping"):
            if gazebo.reference and any(tag.text.lower() in _YES for tag in gazebo.tag.named(name)):
                kept.add(gazebo.reference)
    return kept
