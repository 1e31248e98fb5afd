"""The loads of a robot's joints in its worst pose: the effort that holds its weight, and the inertia that it moves.

The root is fixed. The poses are sampled between the joints' limits, always the same ones.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.generate.robot.coupling import Inverse, inverted
from urdfctl.generate.robot.facts import JointFacts, Load
from urdfctl.generate.robot.frames import NOTHING, Bulk, axis_of, bulk_of, origin_of, outwards, root_of
from urdfctl.model.geometry import (
    ZERO,
    Pose,
    Square,
    Vector,
    about,
    cross,
    dot,
    minus,
    plus,
    product,
    scaled,
    transposed,
    turned,
)
from urdfctl.model.robot import Joint, Robot
from urdfctl.startup.records import NamedTuple

GRAVITY: Vector = (0.0, 0.0, -9.81)
_POSES = (8, 48)
"""The least and the greatest number of sampled poses."""
_EFFORT = 4000
"""The number of joints times poses that is worth the time."""
_COUPLED = 32
"""With more joints than this, couplings between joints are left out."""
_SEED = 7


class _Hinge(NamedTuple):
    joint: Joint
    name: str
    parent: str
    child: str
    origin: Pose
    axis: Vector
    facts: JointFacts | None


class _Placed(NamedTuple):
    """A joint in one pose: its place and axis in the root's frame, and what it carries."""

    hinge: _Hinge
    at: Vector
    axis: Vector
    bulk: Bulk

    @property
    def slides(self) -> bool:
        return self.hinge.joint.type == "prismatic"

    def momentum(self) -> tuple[Vector, Vector]:
        """Return the linear and angular momentum, about the root, of the load at a velocity of 1."""
        bulk, axis = self.bulk, self.axis
        if self.slides:
            return scaled(axis, bulk.mass), cross(bulk.moment, axis)
        straight = cross(axis, minus(bulk.moment, scaled(self.at, bulk.mass)))
        turn = (dot(bulk.inertia[0], axis), dot(bulk.inertia[1], axis), dot(bulk.inertia[2], axis))
        return straight, minus(turn, cross(bulk.moment, cross(axis, self.at)))

    def along(self, linear: Vector, angular: Vector) -> float:
        """Return the part of a momentum that acts along this joint."""
        return dot(self.axis, linear if self.slides else minus(angular, cross(self.at, linear)))

    def weight(self) -> float:
        """Return the effort that holds the load, in N m or N."""
        if self.slides:
            return -self.bulk.mass * dot(self.axis, GRAVITY)
        return -dot(self.axis, cross(minus(self.bulk.moment, scaled(self.at, self.bulk.mass)), GRAVITY))


def loads_of(robot: Robot, joints: Sequence[JointFacts]) -> dict[str, Load]:
    """Return the load of each joint that moves, by name."""
    facts = {joint.name: joint for joint in joints}
    hinges = [
        _Hinge(
            joint=joint,
            name=joint.name or "",
            parent=parent,
            child=child,
            origin=origin_of(next(joint.tag.named("origin"), None)),
            axis=axis_of(joint, Pose()),
            facts=facts.get(joint.name or ""),
        )
        for joint, parent, child in outwards(robot)
    ]
    links = {link.name: link for link in robot.links if link.name}
    bulks = {hinge.child: bulk_of(links.get(hinge.child), Pose()) for hinge in hinges}
    found: dict[str, Load] = {}
    inverses: list[Inverse | None] = []
    for pose in _poses(hinges):
        placed = _placed(hinges, bulks, pose, root_of(robot) or "")
        locked = [one.along(*one.momentum()) for one in placed]
        inverse = _inverse_of(placed, locked)
        inverses.append(inverse)
        for one, inertia in zip(placed, locked, strict=True):
            name = one.hinge.name
            alone = inverse.alone(name) if inverse else None
            load = Load(abs(one.weight()), inertia, max(alone, inertia * _LEAST) if alone else inertia)
            before = found.get(name, load)
            found[name] = Load(
                max(before.gravity, load.gravity),
                max(before.heaviest, load.heaviest),
                min(before.lightest, load.lightest),
            )
    lightest = {name: load.lightest for name, load in found.items()}
    coupling = max(inverse.greatest(lightest) if inverse else math.inf for inverse in inverses)
    return {name: load._replace(coupling=coupling) for name, load in found.items() if load.heaviest > 0}


def _poses(hinges: Sequence[_Hinge]) -> Iterator[dict[str, float]]:
    """The positions of all joints in each sampled pose: zero first."""
    chance = random.Random(_SEED)  # noqa: S311 (the same poses each time)
    moving = [hinge.facts for hinge in hinges if hinge.facts]
    yield _followed({joint.name: 0.0 for joint in moving}, moving)
    for _ in range(max(_POSES[0], min(_POSES[1], _EFFORT // (len(hinges) or 1)))):
        yield _followed({joint.name: chance.uniform(*_range(joint)) for joint in moving}, moving)


def _range(joint: JointFacts) -> tuple[float, float]:
    if joint.type == "continuous" or joint.lower is None or joint.upper is None or joint.lower > joint.upper:
        return (0.0, 0.0) if joint.slides else (-math.pi, math.pi)
    return joint.lower, joint.upper


def _followed(pose: dict[str, float], moving: Sequence[JointFacts]) -> dict[str, float]:
    for joint in moving:
        if joint.mimic and joint.mimic[0] in pose:
            pose[joint.name] = pose[joint.mimic[0]] * joint.mimic[1] + joint.mimic[2]
    return pose


def _placed(hinges: Sequence[_Hinge], bulks: Mapping[str, Bulk], pose: Mapping[str, float], root: str) -> list[_Placed]:
    """The joints that move, each with its load in a pose."""
    frames: dict[str, Pose] = {root: Pose()}
    for hinge in hinges:
        frame = frames[hinge.parent].then(hinge.origin)
        position = pose.get(hinge.name, 0.0)
        if hinge.facts and hinge.facts.slides:
            frame = frame.then(Pose(scaled(hinge.axis, position)))
        elif hinge.facts:
            frame = frame.then(Pose(ZERO, about(hinge.axis, position)))
        frames[hinge.child] = frame
    carried: dict[str, Bulk] = {}
    placed = []
    for hinge in reversed(hinges):
        frame = frames[hinge.child]
        bulk = _moved(bulks[hinge.child], frame).plus(carried.get(hinge.child, NOTHING))
        if hinge.facts:
            placed.append(_Placed(hinge, frame.place, turned(frame.turn, hinge.axis), bulk))
        carried[hinge.parent] = carried.get(hinge.parent, NOTHING).plus(bulk)
    return placed[::-1]


def _moved(bulk: Bulk, frame: Pose) -> Bulk:
    """A mass, given about its link's origin, about the root's origin."""
    if not bulk.mass:
        return bulk
    turned_inertia = product(product(frame.turn, bulk.inertia), transposed(frame.turn))
    moment = turned(frame.turn, bulk.moment)
    (x, y, z), (a, b, c), mass = frame.place, moment, bulk.mass
    shift = (
        (mass * (y * y + z * z) + 2 * (y * b + z * c), -mass * x * y - x * b - y * a, -mass * x * z - x * c - z * a),
        (-mass * x * y - x * b - y * a, mass * (x * x + z * z) + 2 * (x * a + z * c), -mass * y * z - y * c - z * b),
        (-mass * x * z - x * c - z * a, -mass * y * z - y * c - z * b, mass * (x * x + y * y) + 2 * (x * a + y * b)),
    )
    rows = [plus(one, more) for one, more in zip(turned_inertia, shift, strict=True)]
    return Bulk(mass, plus(moment, scaled(frame.place, mass)), (rows[0], rows[1], rows[2]))


_LEAST = 1e-3
"""The least part of its inertia that a joint is assumed to move."""


def _inverse_of(placed: Sequence[_Placed], locked: Sequence[float]) -> Inverse | None:
    """The inverse of the mass matrix of the joints that move freely; None if it is singular, or they are too many."""
    free = [n for n, one in enumerate(placed) if one.hinge.facts and not one.hinge.facts.mimics and locked[n] > 0]
    if not 0 < len(free) <= _COUPLED:
        return None
    parents = {one.hinge.name: one.hinge.facts.above for one in placed if one.hinge.facts}
    row_of = {placed[n].hinge.name: row for row, n in enumerate(free)}
    matrix: Square = [[0.0] * len(free) for _ in free]
    for row, n in enumerate(free):
        momentum = placed[n].momentum()
        upper: str | None = placed[n].hinge.name
        while upper in parents:
            if upper in row_of:
                column = row_of[upper]
                matrix[row][column] = matrix[column][row] = placed[free[column]].along(*momentum)
            upper = parents[upper]
    rows = inverted(matrix)
    return Inverse(row_of, rows) if rows else None
