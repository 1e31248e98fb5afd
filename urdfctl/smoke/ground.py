"""How a robot stands on the ground, by geometry: it rests where its centre of mass is lowest."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.model.geometry import (
    UPRIGHT,
    Pose,
    Rotation,
    Vector,
    about,
    dot,
    minus,
    product,
    transposed,
    turned,
)
from urdfctl.rules.smoke.base_without_mass import base_without_mass
from urdfctl.rules.smoke.robot_tips_over import robot_tips_over
from urdfctl.rules.smoke.wheel_off_the_ground import wheel_off_the_ground
from urdfctl.smoke.mechanism import Mechanism
from urdfctl.smoke.results import ROBOT, Trouble, trouble_of
from urdfctl.smoke.shapes import Shape, Shapes
from urdfctl.smoke.tasks import Task, driven_of
from urdfctl.smoke.traction import traction_troubles
from urdfctl.startup.records import NamedTuple

TIPPED = 0.35
"""From this roll or pitch on, in rad, the robot counts as tipped over."""
TOUCHING = 0.003
"""A wheel that is at most this far above the ground, in m, touches it: contacts give way that much."""
_STEPS = (0.02, 0.004, 0.0008)
"""The tilts that are tried one after the other, in rad."""
_WAYS = tuple((math.cos(n * math.pi / 4), math.sin(n * math.pi / 4), 0.0) for n in range(8))


class Resting(NamedTuple):
    """A robot at rest: its rotation, and the height of each link's lowest point above the ground, in m.

    `contacts` holds the points in which links touch the ground, from the centre of mass, in m.
    """

    turn: Rotation
    heights: dict[str, float]
    contacts: dict[str, list[Vector]]

    @property
    def tilt(self) -> float:
        """The angle between the robot's z axis and straight up, in rad."""
        return math.acos(max(-1.0, min(1.0, self.turn[2][2])))


class _Body(NamedTuple):
    """The robot at spawn as one rigid body: its centre of mass, and its shapes with the poses of their links."""

    centre: Vector
    shapes: tuple[tuple[str, Shape, Pose], ...]

    def depth(self, down: Vector) -> float:
        """The distance from the origin to the lowest point, in m, if this direction is down."""
        return max(_reach(shape, pose, down) for _, shape, pose in self.shapes)


def _reach(shape: Shape, pose: Pose, way: Vector) -> float:
    point = pose.at(shape.farthest(turned(transposed(pose.turn), way)))
    return dot(point, way)


def resting(mechanism: Mechanism, shapes: Shapes) -> Resting | None:
    """Return how a robot comes to rest on flat ground with its joints held at spawn; None if nothing holds it up."""
    poses = mechanism.poses(mechanism.start())
    placed = tuple((name, shape, poses[name]) for name in mechanism.bodies for shape in shapes.known.get(name, ()))
    if not placed or not sum(body.mass for body in mechanism.bodies.values()) > 0:
        return None
    centre = mechanism.centre_of_mass(poses)
    turn = _settled(_Body(centre, placed))
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
    return Resting(turn, heights, contacts)


def _lowest(shape: Shape, pose: Pose, down: Vector) -> list[Vector]:
    """The points of a shape that touch the ground; `down` is the way down."""
    reach = _reach(shape, pose, down)
    low = [corner for point in shape.outline() if dot(corner := pose.at(point), down) > reach - TOUCHING]
    return low or [pose.at(shape.farthest(turned(transposed(pose.turn), down)))]


def _settled(body: _Body) -> Rotation:
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


def _height(body: _Body, turn: Rotation) -> float:
    """The height of the centre of mass above the ground."""
    down = turned(transposed(turn), (0.0, 0.0, -1.0))
    return body.depth(down) - sum(a * b for a, b in zip(body.centre, down, strict=True))


def ground_troubles(mechanism: Mechanism, shapes: Shapes, tasks: Sequence[Task]) -> Iterator[Trouble]:
    """Yield what is wrong with how a robot with driven wheels stands."""
    drives = [task for task in tasks if task.base]
    if not drives:
        return
    yield from _base(mechanism, shapes)
    wheels = {name: task.controller for task in reversed(drives) for name in driven_of(task)}
    hinges = [hinge for hinge in mechanism.hinges if hinge.name in wheels]
    bare = [hinge for hinge in hinges if not shapes.known.get(hinge.child) and hinge.child not in shapes.unknown]
    for hinge in bare:
        yield _lifted(hinge.name, wheels[hinge.name])
    at_rest = resting(mechanism, shapes) if shapes.complete else None
    if at_rest is None or bare:
        return
    if at_rest.tilt > TIPPED:
        roll, pitch = math.atan2(at_rest.turn[2][1], at_rest.turn[2][2]), -math.asin(at_rest.turn[2][0])
        notes = ("check that it has enough wheels or casters",)
        yield trouble_of(robot_tips_over, ROBOT, None, notes, when=" at spawn", roll=roll, pitch=pitch)
        return
    lifted = [hinge for hinge in hinges if at_rest.heights.get(hinge.child, 0.0) > TOUCHING]
    for hinge in lifted:
        yield _lifted(hinge.name, wheels[hinge.name])
    if not lifted:
        yield from traction_troubles(mechanism, at_rest.contacts, tasks)


def _lifted(joint: str, controller: str) -> Trouble:
    return trouble_of(wheel_off_the_ground, f"joint:{joint}", controller, joint=joint)


def _base(mechanism: Mechanism, shapes: Shapes) -> Iterator[Trouble]:
    """The largest part of a robot's base must have a mass."""
    rigid = mechanism.body_of(mechanism.root)
    volumes = {name: sum(shape.volume for shape in shapes.known.get(name, ())) for name in rigid}
    largest = max(volumes, key=volumes.__getitem__)
    if volumes[largest] > 0 and not mechanism.bodies[largest].mass:
        rest = sum(mechanism.bodies[name].mass for name in rigid)
        yield trouble_of(base_without_mass, f"link:{largest}", None, (), link=largest, rest=f"{rest:.3g}")
