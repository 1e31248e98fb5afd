"""What gravity, friction, damping and inertia ask of each joint, by formula."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.geometry import Vector, cross, dot, minus, plus, product, scaled, transposed, turned
from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.effort_too_weak_in_a_pose import effort_too_weak_in_a_pose
from urdfctl.rules.smoke.effort_too_weak_to_move import effort_too_weak_to_move
from urdfctl.rules.smoke.joint_resists_its_motor import joint_resists_its_motor
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.motions import goal_of
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.tasks import Task

GRAVITY: Vector = (0.0, 0.0, -9.81)
LEAST_MARGIN = 0.05
"""An effort limit should exceed the weight on its joint by at least this fraction of the limit."""
POSES = 48
"""The number of poses in which the weight on each joint is computed."""
PLACES = 6
"""The positions of each joint that are tried around the worst pose."""
MOST_REFINED = 12
"""The worst pose is refined only for robots with at most this many joints, because it takes a pose for each place."""
SLOWER = 0.5
"""A joint must reach this fraction of the highest speed that its motion takes."""
TIME = 2.0
"""The time that a motion takes, in s."""


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


def effort_troubles(mechanism: Mechanism, tasks: Sequence[Task]) -> Iterator[Trouble]:
    """Yield the joints whose effort limit is too low: for the weight on them, for their friction, or to move at all."""
    owners: dict[str, Task] = {}
    for task in sorted(tasks, key=lambda task: bool(task.through)):
        for joint in task.joints if task.drive is None else ():
            owners.setdefault(joint, task)
    hinges = {name: hinge for name in owners if (hinge := mechanism.hinge(name)) and hinge.moves and not hinge.mimic}
    at_spawn = gravity_load(mechanism, mechanism.start())
    heavy = set()
    for name, hinge in hinges.items():
        needed = abs(at_spawn.get(name, 0.0))
        if hinge.effort and needed > hinge.effort:
            heavy.add(name)
            fields = {"joint": name, "needed": needed, "unit": hinge.effort_unit, "limit": hinge.effort}
            yield trouble_of(effort_too_weak_for_gravity, f"joint:{name}", owners[name].controller, (), **fields)
    light = [hinge for name, hinge in hinges.items() if name not in heavy and hinge.effort]
    yield from _margins(mechanism, light, owners)
    inertias = moved_inertias(mechanism)
    for hinge in hinges.values():
        if hinge.name not in heavy:
            weight = abs(at_spawn.get(hinge.name, 0.0))
            yield from _motor(hinge, owners[hinge.name], weight, inertias.get(hinge.name, 0.0))


# -- weight in many poses --------------------------------------------------------------------------------------------


def _margins(mechanism: Mechanism, hinges: Sequence[Hinge], owners: Mapping[str, Task]) -> Iterator[Trouble]:
    worst = worst_loads(mechanism, hinges)
    for hinge in hinges:
        needed, pose = worst[hinge.name]
        limit = hinge.effort or math.inf
        if needed <= (1 - LEAST_MARGIN) * limit:
            continue
        shown = ", ".join(f"{name} at {place:.3g}" for name, place in pose.items() if abs(place) > 1e-3)  # noqa: PLR2004
        notes = (f"with {shown}",) if shown else ()
        fields = {"joint": hinge.name, "needed": needed, "unit": hinge.effort_unit, "limit": limit}
        percent = 100 * (1 - needed / limit)
        margin = f"a margin of {percent:.0f} %" if percent >= 0 else f"{-percent:.0f} % too little"
        controller = owners[hinge.name].controller
        yield trouble_of(effort_too_weak_in_a_pose, f"joint:{hinge.name}", controller, notes, **fields, margin=margin)


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


# -- friction, damping and inertia -----------------------------------------------------------------------------------


def _motor(hinge: Hinge, task: Task, weight: float, inertia: float) -> Iterator[Trouble]:
    """A motor must overcome friction, reach the speed of a motion in spite of damping, and accelerate the inertia."""
    goal = goal_of(hinge, hinge.start, 0.0, TIME)
    if hinge.effort is None or hinge.velocity == 0 or not abs(goal.by):
        return
    if hinge.effort == 0 and task.interface != "effort":
        return
    speed = 3 * abs(goal.by) / TIME
    left = hinge.effort - hinge.friction
    fields = {"joint": hinge.name, "unit": hinge.effort_unit, "limit": hinge.effort}
    subject = f"joint:{hinge.name}"
    if hinge.effort and (left <= 0 or left < SLOWER * speed * hinge.damping):
        yield resisted(hinge, task, speed)
        return
    left -= weight
    if left <= 0 and hinge.effort:
        yield resisted(hinge, task, speed, weight)
        return
    moved = 0.5 * left / inertia * TIME**2 if inertia > 0 else math.inf
    if moved < abs(goal.by):
        needed = abs(goal.by) * 2 * inertia / TIME**2 + hinge.friction + weight
        yield trouble_of(effort_too_weak_to_move, subject, task.controller, (), **fields, needed=needed)


def resisted(hinge: Hinge, task: Task, speed: float, weight: float = 0.0) -> Trouble:
    """Return the finding that friction or damping keeps a joint from a speed, in rad/s or m/s.

    `weight` is what the joint carries, in N m or N.
    """
    effort = hinge.effort or 0.0
    left = effort - hinge.friction - weight
    most = max(0.0, left / hinge.damping) if hinge.damping else 0.0
    what = f"friction of {hinge.friction:g} {hinge.effort_unit}" if left <= 0 else f"damping of {hinge.damping:g}"
    if weight:
        what += f" and carries {weight:.3g} {hinge.effort_unit}"
    how = f"at most at {most:.2g} {hinge.unit}/s" if left > 0 else "not at all"
    fields = {"joint": hinge.name, "what": what, "how": how, "limit": effort, "unit": hinge.effort_unit}
    notes = (f"the test motion takes {speed:.2g} {hinge.unit}/s",)
    return trouble_of(joint_resists_its_motor, f"joint:{hinge.name}", task.controller, notes, **fields)


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
