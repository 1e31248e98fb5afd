"""Find the hands of a robot: fingers that follow a motor, are named so, or close like jaws."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.robot.name_words import words_of
from urdfctl.startup.records import NamedTuple

_FINGER = re.compile(r"finger|grip|jaw|claw|grasp|thumb|knuckle|pinch|pincer", re.IGNORECASE)
LIMB = re.compile(r"shoulder|elbow|wrist|arm|hip|knee|leg", re.IGNORECASE)
_BENDS, _ARM = 3, 3
"""A finger has at most this many joints; the arm that carries a hand has at least this many."""
_DIGITS = frozenset(("index", "middle", "ring", "pinky", "little"))
"""Words that name a finger beside a thumb or another finger; elsewhere they say where a part is."""
_PARALLEL = 0.95
"""The least cosine of the angle between the axes of two jaws."""
_PIN = 0.01
"""Two jaws on one pin are at most so far apart along it, in m."""
_JAW = 3.2
"""The greatest range of a jaw that turns, in rad."""
_ALIKE = 0.1
"""How much the limits of two jaws may differ, in parts of their range."""


class Tool(NamedTuple):
    """Fingers at the end of a chain. `single`: one joint moves all of them."""

    joints: tuple[JointFacts, ...]
    single: bool


class JointTree:
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
        found: dict[str, JointFacts] = {}
        pending = [name]
        while pending:
            below = {joint.name: joint for joint in self.below.get(pending.pop(), ()) if joint.name not in found}
            found |= below
            pending += below
        return [*found.values()]

    def led_by(self, name: str) -> list[str]:
        """Return the joints that follow a joint, also those that follow its followers."""
        found: list[str] = []
        pending = [name]
        while pending:
            led = [joint.name for joint in self.followers.get(pending.pop(), ()) if joint.name not in found]
            found += led
            pending += led
        return found

    def over(self, joint: JointFacts) -> list[JointFacts]:
        """Return the joints between a joint and the root, the nearest first."""
        found: list[JointFacts] = []
        while joint.above in self.joints and self.joints[joint.above or ""] not in found:
            joint = self.joints[joint.above or ""]
            found.append(joint)
        return found


def tools_of(tree: JointTree, joints: Sequence[JointFacts]) -> Iterator[Tool]:
    """Yield grippers: a joint that others at the end of a chain mimic, with what they carry, or fingers on one link."""
    names = {joint.name for joint in joints}
    hands = [*_with_long_fingers(tree, joints)]
    taken = {member.name for hand in hands for member in hand}
    hands += _led_hands(tree, [joint for joint in joints if joint.name not in taken])
    yield from (Tool(hand, single=len(hand) == 1) for hand in hands)
    taken = {member.name for hand in hands for member in hand}
    by_place: dict[str | None, list[JointFacts]] = {}
    for joint in joints:
        if joint.name not in taken and (joint.above in names or not tree.under(joint.name)):
            by_place.setdefault(joint.above, []).append(joint)
    for fingers in by_place.values():
        jaws = _jaws(tree, fingers, names - taken) if fingers[0].above in names else []
        members = jaws or _named_fingers([joint for joint in fingers if not tree.under(joint.name)])
        if members:
            yield Tool(tuple(members), single=len(members) == 1)


def _jaws(tree: JointTree, joints: Sequence[JointFacts], free: set[str]) -> list[JointFacts]:
    """The jaws among the joints on one link, with the few joints that each carries."""
    ends = [joint for joint in joints if not tree.under(joint.name)]
    if len(ends) == 2 and all(joint.slides for joint in ends):  # noqa: PLR2004
        return ends
    rows = {joint.name: [joint, *(one for one in tree.under(joint.name) if one.name in free)] for joint in joints}
    short = [
        joint for joint in joints if joint in ends or (len(tree.over(joint)) >= _ARM and _is_short(rows[joint.name]))
    ]
    found = [joint for joint in short if any(_are_jaws(tree, joint, other) for other in short if other is not joint)]
    return [one for joint in found for one in rows[joint.name]]


def _is_short(row: Sequence[JointFacts]) -> bool:
    return len(row) <= _BENDS and not any(LIMB.search(f"{joint.name} {joint.link or ''}") for joint in row)


def _led_hands(tree: JointTree, joints: Sequence[JointFacts]) -> Iterator[tuple[JointFacts, ...]]:
    """Hands of joints that others follow; those on one link that lead only what they carry are fingers of one hand."""
    taken: set[str] = set()
    fingers: dict[str | None, list[JointFacts]] = {}
    for joint in joints:
        hand = _hand_of(tree, joint) if joint.name in tree.followers and joint.name not in taken else []
        led = tuple(other for other in joints if other in hand)
        taken.update(member.name for member in led)
        carried = {below.name for below in tree.under(joint.name)}
        if led and joint.above and carried.issuperset(tree.led_by(joint.name)):
            fingers.setdefault(joint.above, []).extend(led)
        elif led:
            yield led
    yield from map(tuple, fingers.values())


def _named_fingers(joints: Sequence[JointFacts]) -> list[JointFacts]:
    """Those of some joints on one link that are named after fingers."""
    known = [joint for joint in joints if is_named_finger(joint)]
    return [joint for joint in joints if joint in known or (known and _is_digit(joint))]


def _are_jaws(tree: JointTree, one: JointFacts, other: JointFacts) -> bool:
    """Whether two joints on one link turn towards each other at the end of an arm."""
    if one.slides or other.slides or not (one.at and other.at and one.axis and other.axis):
        return False
    along = sum(a * b for a, b in zip(one.axis, other.axis, strict=True))
    gap = [b - a for a, b in zip(one.at, other.at, strict=True)]
    offset = sum(a * b for a, b in zip(gap, one.axis, strict=True))
    beside = math.sqrt(max(0.0, sum(part * part for part in gap) - offset * offset))
    return (
        abs(along) > _PARALLEL
        and abs(offset) < max(beside, _PIN)
        and len(tree.over(one)) > 1
        and _close(one, other, along)
    )


def _close(one: JointFacts, other: JointFacts, along: float) -> bool:
    """Whether the ranges of two joints with parallel axes mirror each other, and each is of one side."""
    ends = [(joint.lower, joint.upper) for joint in (one, other)]
    (low, high), (least, most) = ends
    if low is None or high is None or least is None or most is None:
        return False
    if along > 0:
        least, most = -most, -least
    span = high - low
    mirrored = max(abs(low - least), abs(high - most)) <= _ALIKE * span
    return mirrored and 0 < span <= _JAW and abs(low + high) > _ALIKE * span


def _with_long_fingers(tree: JointTree, joints: Sequence[JointFacts]) -> Iterator[tuple[JointFacts, ...]]:
    """Hands of several fingers on one link, of which one has several joints.

    Where each joint of a robot is named after fingers, that is its name, and says nothing of a part.
    """
    known = {joint.name: joint for joint in joints if is_named_finger(joint)}
    above = [upper.name for joint in known.values() for upper in tree.over(joint) if len(known) < len(joints)]
    free, taken = {joint.name for joint in joints}, set[str]()
    for place in sorted(dict.fromkeys(above), key=lambda name: len(tree.under(name)), reverse=True):
        roots = [joint for joint in joints if joint.above == place and joint.name not in taken]
        carried = [[joint, *(one for one in tree.under(joint.name) if one.name in free)] for joint in roots]
        fingers = [each for each in carried if _is_finger(tree, each)]
        hand = tuple(joint for each in fingers for joint in each)
        if len(hand) > len(fingers) > 1 and any(joint.name in known for joint in hand):
            taken.update(joint.name for joint in hand)
            yield hand


def _is_finger(tree: JointTree, row: Sequence[JointFacts]) -> bool:
    """Whether a joint with what it carries is a finger: all are named so, or one is, and it is short and on an arm."""
    named = [joint for joint in row if is_named_finger(joint) or _is_digit(joint)]
    return len(named) == len(row) or (bool(named) and len(row) <= _BENDS and len(tree.over(row[0])) >= _ARM)


def is_named_finger(joint: JointFacts) -> bool:
    """Return whether the name of a joint or of its link says that it is a part of a hand."""
    return bool(_FINGER.search(f"{joint.name} {joint.link or ''}"))


def _is_digit(joint: JointFacts) -> bool:
    return not _DIGITS.isdisjoint(words_of(f"{joint.name} {joint.link or ''}"))


def _hand_of(tree: JointTree, joint: JointFacts) -> list[JointFacts]:
    """A joint whose followers are at the end of a chain, with the joints that these carry, such as springs of fingers.

    Empty if the joint itself carries others than followers, or one that the followers carry does: they are no fingers.
    """
    followers = tree.led_by(joint.name)
    carried = {below.name: below for name in (joint.name, *followers) for below in tree.under(name)}
    inner = [below for below in carried.values() if not below.mimics]
    within = {joint.name, *followers, *(below.name for below in inner)}
    if any(below.mimic is None or below.mimic[0] not in within for below in carried.values() if below.mimics):
        return []
    if any(not below.mimics for each in (joint, *inner) for below in tree.under(each.name)):
        return []
    return [joint, *inner]
