"""The pose in which a robot comes to rest on the ground, by geometry: where its centre of mass is lowest."""

from __future__ import annotations

import math
from collections.abc import Iterable

from urdfctl.model.geometry import UPRIGHT, Pose, Rotation, Vector, about, dot, minus, product, transposed, turned
from urdfctl.smoke.robot.mechanism import Mechanism
from urdfctl.smoke.robot.shapes import Shape, Shapes
from urdfctl.startup.records import NamedTuple

TIPPED = 0.35
"""From this roll or pitch on, in rad, the robot counts as tipped over."""
TOUCHING = 0.003
"""A wheel that is at most this far above the ground, in m, touches it: contacts give way that much."""
_STEPS = (0.02, 0.004, 0.0008)
"""The tilts that are tried one after the other, in rad."""
_WAYS = tuple((math.cos(n * math.pi / 4), math.sin(n * math.pi / 4), 0.0) for n in range(8))


class RestPose(NamedTuple):
    """The pose of a robot at rest: its rotation, and the height of each link's lowest point above the ground, in m.

    `contacts` holds the points in which links touch the ground, from the centre of mass, in m.
    """

    turn: Rotation
    heights: dict[str, float]
    contacts: dict[str, list[Vector]]

    @property
    def tilt(self) -> float:
        """The angle between the robot's z axis and straight up, in rad."""
        return math.acos(max(-1.0, min(1.0, self.turn[2][2])))


class _RigidRobot(NamedTuple):
    """The robot at spawn as one rigid body: its centre of mass, and its shapes with the poses of their links."""

    centre: Vector
    shapes: tuple[tuple[str, Shape, Pose], ...]

    def depth(self, down: Vector) -> float:
        """The distance from the origin to the lowest point, in m, if this direction is down."""
        return max(_reach(shape, pose, down) for _, shape, pose in self.shapes)


def _reach(shape: Shape, pose: Pose, way: Vector) -> float:
    point = pose.at(shape.farthest(turned(transposed(pose.turn), way)))
    return dot(point, way)


def rest_pose_of(mechanism: Mechanism, shapes: Shapes) -> RestPose | None:
    """Return how a robot comes to rest on flat ground with its joints held at spawn; None if nothing holds it up."""
    poses = mechanism.poses(mechanism.start())
    placed = tuple((name, shape, poses[name]) for name in mechanism.bodies for shape in shapes.known.get(name, ()))
    if not placed or not sum(body.mass for body in mechanism.bodies.values()) > 0:
        return None
    centre = mechanism.centre_of_mass(poses)
    turn = _settled(_RigidRobot(centre, placed))
    down = turned(transposed(turn), (0.0, 0.0, -1.0))
    depth = max(_reach(shape, pose, down) for _, shape, pose in placed)
    heights: dict[str, float] = {}
    contacts: dict[str, list[Vector]] = {}
    for name, shape, pose in placed:
        height = depth - _reach(shape, pose, down)
        if height <= TOUCHING:
            points = [turned(turn, minus(point, centre)) for point in _lowest(shape, pose, down)]
            contacts.setdefault(name, []).extend(points)
        heights[name] = min(heights.get(name, math.inf), height)
    return RestPose(turn, heights, contacts)


def heights_of(mechanism: Mechanism, shapes: Shapes) -> dict[str, float]:
    """Return how far the lowest point of each link is above that of the robot, as it was built, in m."""
    poses, down = mechanism.poses(mechanism.start()), (0.0, 0.0, -1.0)
    reach = {
        name: max(_reach(shape, poses[name], down) for shape in shapes.known[name])
        for name in mechanism.bodies
        if shapes.known.get(name)
    }
    return {name: max(reach.values()) - its for name, its in reach.items()}


def _lowest(shape: Shape, pose: Pose, down: Vector) -> list[Vector]:
    """The points of a shape that touch the ground; `down` is the way down."""
    reach = _reach(shape, pose, down)
    low = [corner for point in shape.outline() if dot(corner := pose.at(point), down) > reach - TOUCHING]
    return low or [pose.at(shape.farthest(turned(transposed(pose.turn), down)))]


def _settled(body: _RigidRobot) -> Rotation:
    """The rotation in which the centre of mass is lowest, reached downhill from upright."""
    turn = UPRIGHT
    height = _height(body, turn)
    for step in _STEPS:
        while turn[2][2] > math.cos(2 * TIPPED):
            tilts = [product(about(way, step), turn) for way in _WAYS]
            heights = [_height(body, tilt) for tilt in tilts]
            best = min(range(len(tilts)), key=heights.__getitem__)
            if heights[best] > height - 1e-9:
                break
            turn, height = tilts[best], heights[best]
    return turn


def _height(body: _RigidRobot, turn: Rotation) -> float:
    """The height of the centre of mass above the ground."""
    down = turned(transposed(turn), (0.0, 0.0, -1.0))
    return body.depth(down) - sum(a * b for a, b in zip(body.centre, down, strict=True))


def carried_by(links: Iterable[str]) -> str:
    """Return the words that name the links on which a robot stands; none if there are none."""
    names = [f"'{name}'" for name in links]
    more = f" and {len(names) - 3} more" if len(names) > 3 else ""  # noqa: PLR2004
    return f": the robot stands on {', '.join(names[:3])}{more}" if names else ""
