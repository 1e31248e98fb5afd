"""Find the parts of a robot that controllers are made for: wheels, grippers, and chains of joints."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from urdfctl.generate.options import Roles
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.startup.records import NamedTuple

_LEVEL = 0.3
"""The greatest vertical component of a wheel's axis: sin 17 deg."""
_UPRIGHT = 0.9
"""The least vertical component of a steering axis: cos 26 deg."""
_UNEVEN = 0.3
"""The greatest height above the lowest wheel, in radii, at which another wheel still touches the ground."""
_TRAIL = 0.25
"""A caster's wheel is at least this far from its swivel axis, in radii."""
_ASKEW = 0.05
"""How much farther to one side than to the other a wheel may be, in track widths."""
_ROLLERS = 4
_FINGERS = 3
_FINGER = re.compile(r"finger|gripper|jaw|claw|gripping|grasp", re.IGNORECASE)
_CASTER = re.compile(r"caster|castor", re.IGNORECASE)
_MECANUM = re.compile(r"mecanum", re.IGNORECASE)
_WHEEL = re.compile(r"wheel|tire|tyre", re.IGNORECASE)


class Base(NamedTuple):
    """A mobile base: the `kind` of its drive, None if it is unclear, `passive` without one, and its joints by role.

    `others` are its joints that are not driven: casters, rollers, and wheels that are only steered.
    """

    kind: str | None
    roles: Roles
    joints: tuple[JointFacts, ...]
    others: tuple[JointFacts, ...] = ()


class Tool(NamedTuple):
    """Fingers at the end of a chain. `single`: one joint moves all of them."""

    joints: tuple[JointFacts, ...]
    single: bool


class Anatomy(NamedTuple):
    """The parts of a robot. Each joint that moves and mimics no other is in one of them."""

    base: Base | None
    tools: tuple[Tool, ...]
    chains: tuple[tuple[JointFacts, ...], ...]


def anatomy_of(robot: RobotFacts, joints: Sequence[JointFacts]) -> Anatomy:
    """Return the parts that some joints of a robot form."""
    tree = _JointTree(robot.joints or joints)
    base = _base(tree, joints, robot.name or "")
    used = {joint.name for joint in (*base.joints, *base.others)} if base else set()
    free = [joint for joint in joints if joint.name not in used and not joint.mimics]
    tools = tuple(_tools(tree, free))
    used |= {joint.name for tool in tools for joint in tool.joints}
    mounts = {joint.above for tool in tools for joint in tool.joints}
    return Anatomy(base, tools, tuple(_chains(tree, [joint for joint in free if joint.name not in used], mounts)))


class _JointTree:
    """The joints of a robot by name, and what hangs on them."""

    def __init__(self, joints: Iterable[JointFacts]) -> None:
        self.joints: Mapping[str, JointFacts] = {joint.name: joint for joint in joints}
        self.below: dict[str | None, list[JointFacts]] = {}
        self.followers: dict[str, list[JointFacts]] = {}
        for joint in self.joints.values():
            self.below.setdefault(joint.above, []).append(joint)
            if joint.mimic:
                self.followers.setdefault(joint.mimic[0], []).append(joint)

    def under(self, name: str) -> list[JointFacts]:
        """Return all joints that a joint carries."""
        found, pending = [], [name]
        while pending:
            below = [joint for joint in self.below.get(pending.pop(), ()) if joint not in found]
            found += below
            pending += [joint.name for joint in below]
        return found

    def over(self, joint: JointFacts) -> list[JointFacts]:
        """Return the joints between a joint and the root, the nearest first."""
        found: list[JointFacts] = []
        while joint.above in self.joints and self.joints[joint.above or ""] not in found:
            joint = self.joints[joint.above or ""]
            found.append(joint)
        return found


# -- mobile bases ----------------------------------------------------------------------------------------------------


def _base(tree: _JointTree, joints: Sequence[JointFacts], name: str) -> Base | None:
    turning = [joint for joint in joints if _may_be_wheel(tree, joint)]
    rolling = [joint for joint in turning if joint.radius or _is_named_wheel(joint)] or _mirrored(tree, turning)
    ground = min((_bottom(wheel) for wheel in rolling), default=0.0)
    wheels = [wheel for wheel in rolling if _bottom(wheel) - ground <= _UNEVEN * (wheel.radius or 0.0) + 1e-6]
    casters = [wheel for wheel in wheels if _is_caster(tree, wheel)]
    driven = [wheel for wheel in wheels if wheel not in casters]
    if not driven:
        passive = tuple(dict.fromkeys(upper for wheel in casters for upper in (wheel, *tree.over(wheel))))
        return Base("passive", Roles(), (), passive) if casters else None
    steered = {upper.name: upper for wheel in driven for upper in tree.over(wheel) if _is_upright(upper)}
    fixed = [wheel for wheel in driven if not any(upper.name in steered for upper in tree.over(wheel))]
    kind, roles = _kind_of_base(tree, driven, fixed, list(steered.values()), name)
    named = {name for role in roles for name in role}
    mine = tuple(joint for joint in tree.joints.values() if joint.name in named)
    around = [upper for wheel in wheels for upper in (wheel, *tree.over(wheel), *tree.under(wheel.name))]
    around += [joint for joint in joints if _is_swivel(tree, joint)]
    others = tuple(dict.fromkeys(joint for joint in around if joint.name not in named))
    return Base(kind, roles, mine, others)


def _may_be_wheel(tree: _JointTree, joint: JointFacts) -> bool:
    """Whether a joint may turn a wheel: level, endless, and on the base itself, a steering joint or a spring."""
    if joint.type != "continuous" or joint.axis is None or abs(joint.axis[2]) > _LEVEL or joint.at is None:
        return False
    carriers = tree.over(joint)
    carried = tree.below.get(joint.name, ())
    if carried and (len(carried) < _ROLLERS or any(tree.below.get(roller.name) for roller in carried)):
        return False
    rockers = [upper for upper in carriers if not (_is_upright(upper) or upper.slides)]
    return not rockers or (_is_named_wheel(joint) and all(_carries_wheels(tree, rocker) for rocker in rockers))


def _is_named_wheel(joint: JointFacts) -> bool:
    return bool(_WHEEL.search(joint.name) or _WHEEL.search(joint.link or ""))


def _mirrored(tree: _JointTree, joints: Sequence[JointFacts]) -> list[JointFacts]:
    """Joints on the base itself of which one on the left mirrors one on the right: its wheels, whatever their names."""
    bare = [joint for joint in joints if joint.at and not tree.over(joint) and not tree.below.get(joint.name)]
    return [joint for joint in bare if any(_mirrors(joint, other) for other in bare)]


def _mirrors(joint: JointFacts, other: JointFacts) -> bool:
    (x, y, z), (across, side, up) = joint.at or (0.0, 0.0, 0.0), other.at or (0.0, 0.0, 0.0)
    return y * side < 0 and max(abs(x - across), abs(y + side), abs(z - up)) <= _ASKEW * abs(y - side)


def _carries_wheels(tree: _JointTree, rocker: JointFacts) -> bool:
    """Whether a joint only carries wheels, as the rockers of a rover do."""
    return all(joint.type == "continuous" for joint in tree.under(rocker.name))


def _is_upright(joint: JointFacts) -> bool:
    return not joint.slides and joint.axis is not None and abs(joint.axis[2]) > _UPRIGHT


def _is_caster(tree: _JointTree, wheel: JointFacts) -> bool:
    swivel = next((upper for upper in tree.over(wheel) if _is_upright(upper)), None)
    if _is_named_caster(wheel):
        return True
    if swivel is None or swivel.type != "continuous" or not swivel.at or not wheel.at or not wheel.axis:
        return False
    gap = wheel.at[0] - swivel.at[0], wheel.at[1] - swivel.at[1]
    trail = abs(gap[0] * wheel.axis[1] - gap[1] * wheel.axis[0])
    return bool(_CASTER.search(swivel.name)) or trail > _TRAIL * (wheel.radius or 0.1)


def _is_swivel(tree: _JointTree, joint: JointFacts) -> bool:
    """Whether a joint on the base itself is by its name a caster whose wheel does not turn by itself."""
    alone = not tree.over(joint) and not tree.below.get(joint.name)
    return alone and not joint.slides and _is_named_caster(joint)


def _is_named_caster(joint: JointFacts) -> bool:
    return bool(_CASTER.search(f"{joint.name} {joint.link or ''}"))


def _kind_of_base(
    tree: _JointTree, wheels: list[JointFacts], fixed: list[JointFacts], steered: list[JointFacts], name: str
) -> tuple[str | None, Roles]:
    left, right = ([wheel for wheel in wheels if wheel.at and wheel.at[1] * side > 0] for side in (1, -1))
    if (
        not steered
        and len(wheels) >= _FINGERS
        and any(abs((wheel.axis or (0, 1, 0))[1]) < _UPRIGHT for wheel in wheels)
    ):
        return "omni", Roles(traction=_left_first(wheels))
    if not steered:
        sides = Roles(left=_front_first(left), right=_front_first(right))
        if len(left) != len(right) or not left:
            return None, Roles(traction=_left_first(wheels))
        rollers = any(len(tree.under(wheel.name)) >= _ROLLERS for wheel in wheels)
        words = (name, *(word for wheel in wheels for word in (wheel.name, wheel.link or "", wheel.macro)))
        mecanum = len(wheels) == 4 and (rollers or any(map(_MECANUM.search, words)))  # noqa: PLR2004
        return ("mecanum" if mecanum else "diff_drive"), sides
    known = {(2, 2): "ackermann", (1, 2): "tricycle_steering", (1, 1): "bicycle"}
    kind = known.get((len(steered), len(fixed)))
    if kind:
        return kind, Roles(traction=_left_first(fixed), steering=_left_first(steered))
    turned = [wheel for wheel in wheels if wheel not in fixed]
    if len(steered) == len(turned) == 1:
        return "tricycle", Roles(traction=_left_first(turned), steering=_left_first(steered))
    if len(steered) == len(turned) == 4:  # noqa: PLR2004
        return "four_wheel_steering", Roles(traction=_left_first(turned), steering=_left_first(steered))
    return None, Roles(traction=_left_first(wheels), steering=_left_first(steered))


def _bottom(wheel: JointFacts) -> float:
    return (wheel.at or (0.0, 0.0, 0.0))[2] - (wheel.radius or 0.0)


def _left_first(joints: Iterable[JointFacts]) -> tuple[str, ...]:
    return tuple(joint.name for joint in sorted(joints, key=lambda one: (-(one.at or _O)[1], -(one.at or _O)[0])))


def _front_first(joints: Iterable[JointFacts]) -> tuple[str, ...]:
    return tuple(joint.name for joint in sorted(joints, key=lambda one: -(one.at or _O)[0]))


_O = (0.0, 0.0, 0.0)


# -- tools and chains ------------------------------------------------------------------------------------------------


def _tools(tree: _JointTree, joints: Sequence[JointFacts]) -> Iterator[Tool]:
    """Grippers: a joint that others at the end of a chain mimic, with what they carry, or fingers on one link."""
    names = {joint.name for joint in joints}
    taken: set[str] = set()
    for joint in joints:
        hand = _hand_of(tree, joint) if joint.name in tree.followers and joint.name not in taken else []
        led = tuple(other for other in joints if other in hand)
        if led:
            taken.update(member.name for member in led)
            yield Tool(led, single=len(led) == 1)
    for whole in _with_long_fingers(tree, [joint for joint in joints if joint.name not in taken]):
        taken.update(member.name for member in whole)
        yield Tool(whole, single=False)
    ends = [joint for joint in joints if joint.name not in taken and not tree.under(joint.name)]
    by_place: dict[str | None, list[JointFacts]] = {}
    for joint in ends:
        by_place.setdefault(joint.above, []).append(joint)
    for above, fingers in by_place.items():
        named = [joint for joint in fingers if _is_named_finger(joint)]
        pair = len(fingers) == 2 and all(joint.slides for joint in fingers) and above in names  # noqa: PLR2004
        members = fingers if pair else named
        if members:
            yield Tool(tuple(members), single=len(members) == 1)


def _with_long_fingers(tree: _JointTree, joints: Sequence[JointFacts]) -> Iterator[tuple[JointFacts, ...]]:
    """Hands of several fingers on one link, of which one has several joints: all are named after it.

    Where each joint of a robot is named so, that is its name, and says nothing of a part.
    """
    named = [joint for joint in joints if _is_named_finger(joint)]
    places = dict.fromkeys(joint.above for joint in named if joint.above and len(named) < len(joints))
    free, taken = {joint.name for joint in joints}, set[str]()
    for place in sorted(places, key=lambda above: len(tree.under(above)), reverse=True):
        roots = [joint for joint in named if joint.above == place and joint.name not in taken]
        carried = [[joint, *(one for one in tree.under(joint.name) if one.name in free)] for joint in roots]
        fingers = [each for each in carried if all(map(_is_named_finger, each))]
        if len(fingers) > 1 and any(len(each) > 1 for each in fingers):
            hand = tuple(joint for each in fingers for joint in each)
            taken.update(joint.name for joint in hand)
            yield hand


def _is_named_finger(joint: JointFacts) -> bool:
    return bool(_FINGER.search(f"{joint.name} {joint.link or ''}"))


def _hand_of(tree: _JointTree, joint: JointFacts) -> list[JointFacts]:
    """A joint whose followers are at the end of a chain, with the joints that these carry, such as springs of fingers.

    Empty if the joint itself carries others than followers, or one that the followers carry does: they are no fingers.
    """
    followers = {follower.name for follower in tree.followers[joint.name]}
    carried = {below.name: below for name in (joint.name, *followers) for below in tree.under(name)}
    inner = [below for below in carried.values() if not below.mimics]
    within = {joint.name, *(below.name for below in inner)}
    if any(below.mimic is None or below.mimic[0] not in within for below in carried.values() if below.mimics):
        return []
    if any(not below.mimics for each in (joint, *inner) for below in tree.under(each.name)):
        return []
    return [joint, *inner]


def _chains(
    tree: _JointTree, joints: Sequence[JointFacts], mounts: Collection[str | None]
) -> Iterator[tuple[JointFacts, ...]]:
    """The remaining joints in chains from the root outwards. A chain ends where it branches, or carries a tool."""
    names = {joint.name: joint for joint in joints}
    below: dict[str | None, list[JointFacts]] = {}
    for joint in joints:
        upper = next((over.name for over in tree.over(joint) if over.name in names), None)
        below.setdefault(upper, []).append(joint)
    pending = [[joint] for joint in reversed(below.get(None, []))]
    while pending:
        chain = pending.pop()
        while len(below.get(chain[-1].name, ())) == 1 and chain[-1].name not in mounts:
            chain.append(below[chain[-1].name][0])
        branches = below.get(chain[-1].name, [])
        if len(branches) >= _FINGERS and all(_FINGER.search(joint.name + (joint.link or "")) for joint in branches):
            yield tuple(chain)
            yield tuple(joint for joint in tree.under(chain[-1].name) if joint.name in names)
            continue
        yield tuple(chain)
        pending += [[joint] for joint in reversed(branches)]
