"""The bodies that Gazebo makes of a robot: sdformat lumps links that fixed joints join, and drops what weighs nothing."""

from __future__ import annotations

from urdfctl.model.robot import Inertial, Joint, Link, Robot
from urdfctl.record import NamedTuple
from urdfctl.rules.urdf.tree import WORLD, Tree, parent_of

LEAST_MASS = 1e-6
"""In kg; sdformat takes a smaller mass for none."""
_YES = ("true", "yes", "1")


class Body(NamedTuple):
    """Links that move as one: `head` hangs by `joint` on another body, and `links` are lumped into it.

    `lost` tells how many joints that move vanish with the body: its own, and those below it.
    """

    head: Link
    joint: Joint | None
    links: list[Link]
    lost: int

    @property
    def is_weightless(self) -> bool:
        """Whether sdformat finds no mass in it."""
        return all(mass_of(link) <= LEAST_MASS for link in self.links)


def inertial_of(link: Link) -> Inertial | None:
    """The `<inertial>` that is read: the first one."""
    return link.inertials[0] if link.inertials else None


def mass_of(link: Link) -> float:
    """In kg; 0 where a link has none that can be read. A negative one is refused, which is another matter."""
    inertial = inertial_of(link)
    mass = inertial.mass.value if inertial and inertial.mass else None
    return abs(mass) if mass is not None else 0.0


def bodies(robot: Robot) -> list[Body]:
    """The bodies of a robot, each before those below it."""
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
    """The weightless bodies that Gazebo drops, with joints that move or the link of a fixed joint that was to be kept."""
    return [
        body
        for body in bodies(robot)
        if body.is_weightless
        and (body.lost or (body.joint is not None and parent_of(body.joint) != WORLD))
        and body.head.name != WORLD
    ]


def _kept_joints(robot: Robot) -> set[str]:
    """The fixed joints that `<gazebo reference="...">` asks to keep."""
    kept = set()
    for gazebo in robot.gazebos:
        for name in ("preserveFixedJoint", "disableFixedJointLumping"):
            if gazebo.reference and any(tag.text.lower() in _YES for tag in gazebo.tag.named(name)):
                kept.add(gazebo.reference)
    return kept
