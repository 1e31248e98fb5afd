"""The effort that holds each joint of a robot against gravity, and the inertia that each joint moves."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.geometry import Vector, cross, dot, minus, plus, product, scaled, transposed, turned
from urdfctl.smoke.robot.mechanism import Hinge, Mechanism

GRAVITY: Vector = (0.0, 0.0, -9.81)
POSES = 48
"""The number of poses in which the weight on each joint is computed."""
PLACES = 6
"""The positions of each joint that are tried around the worst pose."""
MOST_REFINED = 12
"""The worst pose is refined only for robots with at most this many joints, because it takes a pose for each place."""


def gravity_load(mechanism: Mechanism, positions: Mapping[str, float]) -> dict[str, float]:
    """Return the effort of each hinge that holds the robot still, in N m or N, while its root is fixed."""
    poses = mechanism.poses(positions)
    masses, moments = {}, {}
    for name, body in mechanism.bodies.items():
        masses[name] = body.mass if body.falls else 0.0
        moments[name] = scaled(poses[name].at(body.centre), masses[name])
    load = {}
    for hinge in reversed(mechanism.hinges):
        mass, moment = masses[hinge.child], moments[hinge.child]
        masses[hinge.parent] += mass
        moments[hinge.parent] = plus(moments[hinge.parent], moment)
        if hinge.moves:
            pose = poses[hinge.child]
            axis = turned(pose.turn, hinge.axis)
            lever = minus(moment, scaled(pose.place, mass))
            force = scaled(GRAVITY, mass) if hinge.type == "prismatic" else cross(lever, GRAVITY)
            load[hinge.name] = -dot(axis, force)
    return load


def worst_loads(mechanism: Mechanism, hinges: Sequence[Hinge]) -> dict[str, tuple[float, dict[str, float]]]:
    """Return the greatest weight on each hinge in many poses, in N m or N, with the pose."""
    worst = {hinge.name: (-1.0, dict[str, float]()) for hinge in hinges}
    if not hinges:
        return worst
    for pose in (mechanism.start(), *sampled_poses(mechanism)):
        _note(worst, gravity_load(mechanism, pose), pose)
    movable = mechanism.movable
    if len(movable) <= MOST_REFINED:
        for hinge in hinges:
            if worst[hinge.name][0] > (hinge.effort or 0.0) / 2:
                _refine(mechanism, movable, worst, hinge.name)
    return worst


def _refine(
    mechanism: Mechanism, movable: Sequence[Hinge], worst: dict[str, tuple[float, dict[str, float]]], name: str
) -> None:
    """Move one joint after the other to where the weight on a hinge is greatest."""
    for hinge in movable:
        low, high = hinge.span
        for n in range(PLACES + 1):
            pose = {**worst[name][1], hinge.name: low + (high - low) * n / PLACES}
            _note(worst, gravity_load(mechanism, pose), pose)


def _note(
    worst: dict[str, tuple[float, dict[str, float]]], load: Mapping[str, float], pose: Mapping[str, float]
) -> None:
    for name, (most, _) in worst.items():
        if abs(load.get(name, 0.0)) > most:
            worst[name] = abs(load.get(name, 0.0)), dict(pose)


def sampled_poses(mechanism: Mechanism) -> Iterator[dict[str, float]]:
    """Yield poses spread over the joints' ranges by chance, the same in every run."""
    chance = random.Random(0)  # noqa: S311 (no secret)
    for _ in range(POSES):
        yield {hinge.name: chance.uniform(*hinge.span) for hinge in mechanism.movable}


def moved_inertias(mechanism: Mechanism) -> dict[str, float]:
    """Return the inertia that each hinge moves at spawn while all others are held, in kg m² (kg if it slides)."""
    poses = mechanism.poses(mechanism.start())
    masses, moments, inertias = {}, {}, {}
    for name, body in mechanism.bodies.items():
        centre, turn = poses[name].at(body.centre), poses[name].turn
        masses[name], moments[name] = body.mass, scaled(centre, body.mass)
        own = product(product(turn, body.inertia), transposed(turn))
        inertias[name] = _sum(own, _of_point(centre, body.mass))
    moved = {}
    for hinge in reversed(mechanism.hinges):
        mass, moment, inertia = masses[hinge.child], moments[hinge.child], inertias[hinge.child]
        masses[hinge.parent] += mass
        moments[hinge.parent] = plus(moments[hinge.parent], moment)
        inertias[hinge.parent] = _sum(inertias[hinge.parent], inertia)
        pose = poses[hinge.child]
        axis = turned(pose.turn, hinge.axis)
        away = cross(axis, pose.place)
        about = sum(axis[n] * dot(inertia[n], axis) for n in range(3))
        turning = about - 2 * dot(away, cross(axis, moment)) + mass * dot(away, away)
        moved[hinge.name] = mass if hinge.type == "prismatic" else turning
    return moved


def _sum(a: Sequence[Sequence[float]], b: Sequence[Sequence[float]]) -> list[list[float]]:
    return [[x + y for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def _of_point(place: Vector, mass: float) -> list[list[float]]:
    """The inertia of a point about the origin."""
    square = dot(place, place)
    return [[mass * (square * (n == m) - place[n] * place[m]) for m in range(3)] for n in range(3)]
