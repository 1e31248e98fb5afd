"""Find the parts of a robot that controllers are made for: wheels, grippers, and chains of joints."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import takewhile

from urdfctl.generate.options import Roles
from urdfctl.generate.robot.facts import JointFacts, RobotFacts
from urdfctl.generate.robot.hands import LIMB, JointTree, Tool, is_named_finger, tools_of
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
ARM, SHORT = 5, 3
"""An arm has at least this many joints; a chain that carries one has at most this many."""
_LIFT = re.compile(r"lift|torso|trunk|rail|gantry|elevator|column", re.IGNORECASE)
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


class Anatomy(NamedTuple):
    """The parts of a robot. Each joint that moves and mimics no other is in one of them."""

    base: Base | None
    tools: tuple[Tool, ...]
    chains: tuple[tuple[JointFacts, ...], ...]


def anatomy_of(robot: RobotFacts, joints: Sequence[JointFacts]) -> Anatomy:
    """Return the parts that some joints of a robot form."""
    tree = JointTree(robot.joints or joints)
    base = _base(tree, joints, robot.name or "")
    used = {joint.name for joint in (*base.joints, *base.others)} if base else set()
    free = [joint for joint in joints if joint.name not in used and not joint.mimics]
    tools = tuple(tools_of(tree, free))
    used |= {joint.name for tool in tools for joint in tool.joints}
    mounts = {joint.above for tool in tools for joint in tool.joints}
    return Anatomy(base, tools, tuple(_chains(tree, [joint for joint in free if joint.name not in used], mounts)))


# -- mobile bases ----------------------------------------------------------------------------------------------------


def _base(tree: JointTree, joints: Sequence[JointFacts], name: str) -> Base | None:
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


def _may_be_wheel(tree: JointTree, joint: JointFacts) -> bool:
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


def _mirrored(tree: JointTree, joints: Sequence[JointFacts]) -> list[JointFacts]:
    """Joints on the base itself of which one on the left mirrors one on the right: its wheels, whatever their names."""
    bare = [joint for joint in joints if joint.at and not tree.over(joint) and not tree.below.get(joint.name)]
    return [joint for joint in bare if any(_mirrors(joint, other) for other in bare)]


def _mirrors(joint: JointFacts, other: JointFacts) -> bool:
    (x, y, z), (across, side, up) = joint.at or (0.0, 0.0, 0.0), other.at or (0.0, 0.0, 0.0)
    return y * side < 0 and max(abs(x - across), abs(y + side), abs(z - up)) <= _ASKEW * abs(y - side)


def _carries_wheels(tree: JointTree, rocker: JointFacts) -> bool:
    """Whether a joint only carries wheels, as the rockers of a rover do."""
    return all(joint.type == "continuous" for joint in tree.under(rocker.name))


def _is_upright(joint: JointFacts) -> bool:
    return not joint.slides and joint.axis is not None and abs(joint.axis[2]) > _UPRIGHT


def _is_caster(tree: JointTree, wheel: JointFacts) -> bool:
    swivel = next((upper for upper in tree.over(wheel) if _is_upright(upper)), None)
    if _is_named_caster(wheel):
        return True
    if swivel is None or swivel.type != "continuous" or not swivel.at or not wheel.at or not wheel.axis:
        return False
    gap = wheel.at[0] - swivel.at[0], wheel.at[1] - swivel.at[1]
    trail = abs(gap[0] * wheel.axis[1] - gap[1] * wheel.axis[0])
    return bool(_CASTER.search(swivel.name)) or trail > _TRAIL * (wheel.radius or 0.1)


def _is_swivel(tree: JointTree, joint: JointFacts) -> bool:
    """Whether a joint on the base itself is by its name a caster whose wheel does not turn by itself."""
    alone = not tree.over(joint) and not tree.below.get(joint.name)
    return alone and not joint.slides and _is_named_caster(joint)


def _is_named_caster(joint: JointFacts) -> bool:
    return bool(_CASTER.search(f"{joint.name} {joint.link or ''}"))


def _kind_of_base(
    tree: JointTree, wheels: list[JointFacts], fixed: list[JointFacts], steered: list[JointFacts], name: str
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


# -- chains ----------------------------------------------------------------------------------------------------------


def _chains(
    tree: JointTree, joints: Sequence[JointFacts], mounts: Collection[str | None]
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
        if len(branches) >= _FINGERS and all(is_named_finger(joint) for joint in branches):
            yield from _parted(chain)
            yield tuple(joint for joint in tree.under(chain[-1].name) if joint.name in names)
            continue
        yield from _parted(chain)
        pending += [[joint] for joint in reversed(branches)]


def _parted(chain: Sequence[JointFacts]) -> Iterator[tuple[JointFacts, ...]]:
    """A chain, or the lift, rail or torso at its root and the arm on that."""
    root = tuple(takewhile(_is_lift, chain))
    arm = tuple(chain[len(root) :])
    is_carrier = 0 < len(root) <= SHORT and sum(not joint.slides for joint in arm) >= ARM
    yield from (root, arm) if is_carrier else (tuple(chain),)


def _is_lift(joint: JointFacts) -> bool:
    words = f"{joint.name} {joint.link or ''}"
    return joint.slides or bool(_LIFT.search(words) and not LIMB.search(words))
