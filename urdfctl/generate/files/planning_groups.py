"""The planning groups of a robot for MoveIt: for each controller that MoveIt uses, and those that a user asks for."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import count

from urdfctl.errors import UserError
from urdfctl.generate.controllers.parameters import GeneratedController
from urdfctl.generate.request.planning_group import LinkTree, PlanningGroup, asked_group
from urdfctl.generate.robot.anatomy import ARM, SHORT
from urdfctl.generate.robot.facts import LinkFacts
from urdfctl.generate.robot.hands import Tool

_TIPS = ("tool0", "tcp", "tool", "tip", "end_effector", "eef", "ee", "flange", "grasp", "hand")
"""Words of the names of links at which a chain ends, the best first."""
_HELD = ("tcp", "tool0", "tool", "grasp", "grasping", "end_effector", "eef", "ee")
"""Words of the names of frames between the fingers of a tool."""
_TOOL = re.compile(r"gripper|finger|hand|jaw|claw", re.IGNORECASE)
_RIGID = re.compile(r"gripper|hand|suction|vacuum|pump|magnet", re.IGNORECASE)
_NO_TOOL = re.compile(r"camera|sensor|mount|adapter|coupl|flange", re.IGNORECASE)
_REACH = 3
"""An arm that carries a tool without joints has at least this many joints."""
_OF_TYPE = re.compile(r"(?:^|_)(?:(?:joint_)?traj(?:ectory)?_)?controller$")
"""What the name of a controller says of its type."""
_UNNAMED, _HAND = "arm", "gripper"


def planning_groups(
    made: Sequence[GeneratedController],
    links: Sequence[LinkFacts],
    given: Sequence[str],
    tools: Sequence[Tool] = (),
    *,
    solid: Collection[str] = (),
    bare: bool = False,
) -> tuple[PlanningGroup, ...]:
    """Return the groups for these controllers, and the `given` ones. UserError if one does not fit the robot.

    tools: those of the robot; several controllers of one have a group together.
    solid: the links that can collide; one that is fixed to the end of an arm and named as a tool has a group.
    bare: whether a tool without a controller has a group.
    """
    tree = LinkTree(links)
    asked = [asked_group(text, tree) for text in given]
    taken = {group.joints for group in asked} | {(group.name,) for group in asked}
    groups = [*_of_controllers(made, tree, tools), *(_bare(made, tools) if bare else ())]
    groups = [*asked, *(group for group in groups if group.joints not in taken and (group.name,) not in taken)]
    names = [group.name for group in groups]
    for name in names:
        if names.count(name) > 1:
            raise UserError(f"two groups are named '{name}'")
    standing = [(arm, below) for arm, below in _standing(groups, tree) if f"{arm}_with_{below}" not in names]
    joined = {group.name: group for group in _joined(groups, tree)}
    known = {group.joints for group in groups}
    whole = [_whole(joined[arm], joined[below]) for arm, below in standing]
    rigid = _rigid([*joined.values()], tree, solid)
    return (*joined.values(), *rigid, *(group for group in whole if group.joints not in known))


def _of_controllers(
    made: Sequence[GeneratedController], tree: LinkTree, tools: Sequence[Tool]
) -> Iterator[PlanningGroup]:
    """A group for each controller, or for those that move parts of one tool."""
    hands = [*({joint.name for joint in tool.joints} for tool in tools), *_of_grippers(made, tree)]
    together = [[one for one in made if _joints_of(one) and hand.issuperset(_joints_of(one))] for hand in hands]
    told: set[str] = set()
    for controller in made:
        shared = next((each for each in together if controller in each and len(each) > 1), None)
        if shared is None:
            yield _proposed(controller, tree, hands)
        elif controller.name not in told:
            told.update(one.name for one in shared)
            yield PlanningGroup(_common(shared), tuple(name for one in shared for name in _joints_of(one)))


def _of_grippers(made: Sequence[GeneratedController], tree: LinkTree) -> list[set[str]]:
    """The joints of each hand on one link whose joints have a gripper controller each, and no followers."""
    followed = {joint.mimic[0] for one in made[:1] for joint in one.task.robot.joints if joint.mimic}
    single = [_joints_of(one)[0] for one in made if _is_gripper(one) and len(_joints_of(one)) == 1]
    hands: dict[str, set[str]] = {}
    for name in [name for name in single if name not in followed and name in tree.of_joint]:
        above = [link for link in tree.up(tree.of_joint[name].parent) if link.type != "fixed"]
        mount = next((link.name for link in above if link.joint not in single), tree.root)
        hands.setdefault(mount, set()).add(name)
    return [hand for hand in hands.values() if len(hand) > 1]


def _is_gripper(controller: GeneratedController) -> bool:
    return "Gripper" in controller.type.type


def _bare(made: Sequence[GeneratedController], tools: Sequence[Tool]) -> Iterator[PlanningGroup]:
    """A group for each tool that no controller moves, so that it can be mounted and what it holds be attached."""
    moved = {name for one in made for name in _joints_of(one)}
    names = {_name_of(one) for one in made}
    for tool in tools:
        joints = tuple(joint.name for joint in tool.joints)
        if moved.isdisjoint(joints):
            name = next(one for n in count(1) if (one := _HAND if n == 1 else f"{_HAND}_{n}") not in names)
            names.add(name)
            yield PlanningGroup(name, joints)


def _common(controllers: Sequence[GeneratedController]) -> str:
    """The words that the names of several controllers have in common."""
    words = [_name_of(one).split("_") for one in controllers]
    return _OF_TYPE.sub("", "_".join(word for word in words[0] if all(word in each for each in words))) or _HAND


def _name_of(controller: GeneratedController) -> str:
    return _OF_TYPE.sub("", controller.name) or _UNNAMED


def _joints_of(controller: GeneratedController) -> tuple[str, ...]:
    """The joints that a controller moves; in place of one that follows others, the leader, which MoveIt plans for."""
    followed = {joint.name: joint.mimic[0] for joint in controller.task.robot.joints if joint.mimic}
    return tuple(dict.fromkeys(_leader(joint.name, followed) for joint in controller.task.joints))


def _leader(name: str, followed: Mapping[str, str]) -> str:
    passed = {name}
    while followed.get(name, name) not in passed:
        name = followed[name]
        passed.add(name)
    return name


def _proposed(controller: GeneratedController, tree: LinkTree, hands: Sequence[set[str]]) -> PlanningGroup:
    joints = _joints_of(controller)
    ends = None if _is_tool(controller, joints, hands) else _ends_of(joints, tree)
    return PlanningGroup(_name_of(controller), joints, *(ends or (None, None)))


def _is_tool(controller: GeneratedController, joints: Sequence[str], hands: Sequence[set[str]]) -> bool:
    if _is_gripper(controller) or any(hand.issuperset(joints) for hand in hands):
        return True
    return bool(_TOOL.search(controller.name)) and all(_TOOL.search(name) for name in joints)


def _ends_of(joints: Sequence[str], tree: LinkTree) -> tuple[str, str] | None:
    """The links at the ends of the chain that some joints form, if they form one and nothing else moves in it."""
    if any(name not in tree.of_joint for name in joints):
        return None
    depth = {name: len(list(tree.up(tree.of_joint[name].name))) for name in joints}
    first, last = min(joints, key=depth.__getitem__), max(joints, key=depth.__getitem__)
    base, tip = tree.of_joint[first].parent, tree.of_joint[last].name
    moving = tree.moving(base, tip)
    return (_whole_base(base, tree), tip) if moving is not None and sorted(moving) == sorted(joints) else None


def _whole_base(base: str, tree: LinkTree) -> str:
    """The link that a base is a part of by its name, such as base_link for the inertia of base_link; else the base."""
    link = tree.links[base]
    is_part = link.type == "fixed" and base.startswith(f"{link.parent}_") and not base.endswith("link")
    return link.parent if is_part else base


def _rigid(groups: Sequence[PlanningGroup], tree: LinkTree, solid: Collection[str]) -> Iterator[PlanningGroup]:
    """A group for each tool without joints, such as a suction cup, at the end of an arm that carries no other."""
    carriers, names = {group.carrier for group in groups}, {group.name for group in groups}
    listed = {joint for group in groups if not group.tip for joint in group.joints}
    for arm in groups:
        moving = tree.moving(arm.base, arm.tip) if arm.base and arm.tip and arm.name not in carriers else None
        if arm.tip is None or not moving or len(moving) < _REACH or not listed.isdisjoint(moving):
            continue
        fixed = tree.welded(tree.of_joint[moving[-1]].name)[1:]
        body = next(
            (name for name in fixed if name in solid and _RIGID.search(name) and not _NO_TOOL.search(name)), None
        )
        mount = tree.links[body].parent if body else ""
        if body and mount in {link.name for link in tree.up(arm.tip)}:
            stem = f"{arm.name}_{_HAND}" if len([one for one in groups if one.tip]) > 1 else _HAND
            name = next(one for n in count(1) if (one := stem if n == 1 else f"{stem}_{n}") not in names)
            names.add(name)
            yield PlanningGroup(name, (), mount=mount, carrier=arm.name, links=tuple(tree.welded(body)))


def _standing(groups: Sequence[PlanningGroup], tree: LinkTree) -> Iterator[tuple[str, str]]:
    """The arms that stand on a short chain of their own, such as a torso that lifts one, each with that chain."""
    for below in groups:
        if not below.tip or len(below.joints) > SHORT:
            continue
        welded = tree.welded(below.tip)
        on_it = [group for group in groups if group.base in welded and len(group.joints) >= ARM]
        if len(on_it) == 1:
            yield on_it[0].name, below.name


def _whole(arm: PlanningGroup, below: PlanningGroup) -> PlanningGroup:
    return PlanningGroup(f"{arm.name}_with_{below.name}", (*below.joints, *arm.joints), below.base, arm.tip)


def _joined(groups: Sequence[PlanningGroup], tree: LinkTree) -> Iterator[PlanningGroup]:
    """The groups with the tools mounted on the chains, and each proposed chain up to its tool or its last frame."""
    mounts = {group.name: _mount(group, tree) for group in groups if group.tip is None}
    asked_ends = {group.tip for group in groups if group.tip}
    extended = {}
    for group in groups:
        if group.tip:
            welded = tree.welded(group.tip)
            on_it = [mount for mount in mounts.values() if mount in welded]
            others = asked_ends - {group.tip}
            held = tree.welded(on_it[0])[1:] if on_it else []
            extended[group.name] = _named_frame(held, others, _HELD) or on_it[0] if on_it else _frame(welded, others)
    for group in groups:
        if group.tip:
            yield group._replace(tip=extended[group.name])
            continue
        mount = mounts[group.name]
        carriers = [other for other in groups if other.tip and mount in tree.welded(other.tip)]
        carrier = carriers[0].name if carriers else None
        yield group._replace(mount=mount if carrier else None, carrier=carrier)


def _mount(group: PlanningGroup, tree: LinkTree) -> str | None:
    """The link that carries all joints of a group: it moves with none of them."""
    ways = [[link.name for link in tree.up(tree.of_joint[n].parent)] for n in group.joints if n in tree.of_joint]
    own = {tree.of_joint[name].name for name in group.joints if name in tree.of_joint}
    common = [name for name in (ways[0] if ways else ()) if all(name in way for way in ways)]
    return next((name for name in common if not own & {link.name for link in tree.up(name)}), None)


def _frame(welded: Sequence[str], taken: set[str]) -> str:
    """The frame at the end of a chain: the link of the best name, else the last one of a row, else the link itself."""
    return _named_frame(welded, taken, _TIPS) or welded[0]


def _named_frame(links: Sequence[str], taken: set[str], words: Sequence[str]) -> str | None:
    """The link whose name has the best of some words, if any has one."""
    for word in words:
        for name in links:
            if name not in taken and re.search(rf"(?:^|[^a-z0-9]){word}(?:$|[^a-z0-9])", name.lower()):
                return name
    return None
