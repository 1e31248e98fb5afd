"""Fingers that mimic each other: some pair of them must close."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from itertools import combinations

from urdfctl.model.geometry import Pose, Vector, cross, dot, minus, scaled, turned
from urdfctl.rules.smoke.fingers_move_alike import fingers_move_alike
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism

ALONG = 0.6
"""A finger moves towards another one if at least this part of its motion points to it."""
CLOSES, ALIKE = 0.5, 0.1
"""Two fingers close if their distance changes by at least the first part of their motion, and move alike if it changes
by less than the second."""
_FINGER = re.compile(r"finger|jaw|claw|grip|thumb|pinch|tong|knuckle", re.IGNORECASE)


def finger_troubles(mechanism: Mechanism) -> Iterator[Trouble]:
    """Yield the followers that move to the same side as the finger that they mimic, so that these never close."""
    poses = mechanism.poses({h.name: sum(h.span) / 2 if h.type != "continuous" else 0.0 for h in mechanism.movable})
    followers: dict[str, list[Hinge]] = {}
    for hinge in mechanism.hinges:
        if hinge.mimic and hinge.moves:
            followers.setdefault(hinge.mimic[0], []).append(hinge)
    for leader in (hinge for hinge in mechanism.movable if hinge.name in followers):
        group = [hinge for hinge in (leader, *followers[leader.name]) if _is_finger(mechanism, hinge, leader)]
        pairs = [(a, b, _approach(mechanism, poses, a, b)) for a, b in combinations(group, 2)]
        alike = [(a, b) for a, b, how in pairs if how is not None and how < ALIKE]
        if alike and not any(how is not None and how > CLOSES for _, _, how in pairs):
            first, follower = alike[0]
            yield trouble_of(
                fingers_move_alike, f"joint:{follower.name}", None, (), joint=follower.name, leader=first.name
            )


def _is_finger(mechanism: Mechanism, hinge: Hinge, leader: Hinge) -> bool:
    """Whether a joint moves an end beside that of the leader: a slide, or something that is named like a finger."""
    below = mechanism.below(hinge.child)
    ends = not any(each.moves for each in mechanism.hinges if each.parent in below)
    beside = _base(mechanism, hinge) == _base(mechanism, leader)
    named = hinge.type == "prismatic" or bool(_FINGER.search(f"{hinge.name} {hinge.child}"))
    return ends and beside and named and hinge.type != "continuous"


def _base(mechanism: Mechanism, hinge: Hinge) -> str:
    """The first link of the rigid body that a joint is mounted on."""
    above = mechanism.above(hinge.parent)
    fixed = next((n for n, each in enumerate(above) if each.moves), len(above))
    return above[fixed - 1].parent if fixed else hinge.parent


def _approach(mechanism: Mechanism, poses: Mapping[str, Pose], one: Hinge, other: Hinge) -> float | None:
    """By which part of their motion the distance of two fingers changes; None if they do not move along it."""
    places = [poses[hinge.child].at(mechanism.bodies[hinge.child].centre) for hinge in (one, other)]
    apart = minus(places[1], places[0])
    distance = math.sqrt(dot(apart, apart))
    ways = [_motion(poses, hinge, place) for hinge, place in zip((one, other), places, strict=True)]
    sizes = [math.sqrt(dot(way, way)) for way in ways]
    if distance < 1e-4 or min(sizes) < 1e-6:  # noqa: PLR2004 (in one place, or still)
        return None
    line = scaled(apart, 1 / distance)
    along = [dot(way, line) for way in ways]
    if any(abs(part) < ALONG * size for part, size in zip(along, sizes, strict=True)):
        return None
    return abs(along[0] - along[1]) / (abs(along[0]) + abs(along[1]))


def _motion(poses: Mapping[str, Pose], hinge: Hinge, place: Vector) -> Vector:
    """The velocity of a place on a finger while the leader moves at 1 rad/s or m/s."""
    pose, factor = poses[hinge.child], hinge.mimic[1] if hinge.mimic else 1.0
    axis = scaled(turned(pose.turn, hinge.axis), factor)
    return axis if hinge.type == "prismatic" else cross(axis, minus(place, pose.place))
