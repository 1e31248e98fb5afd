"""The physics that needs no engine: the sides and axes of wheels, and the load of gravity on joints."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.geometry import Pose, Vector, cross, dot, minus, transposed, turned
from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.inertia_unusable import inertia_unusable
from urdfctl.rules.smoke.joint_held_still import joint_held_still
from urdfctl.rules.smoke.wheel_measures_differ import wheel_measures_differ
from urdfctl.rules.smoke.wheel_sides_swapped import wheel_sides_swapped
from urdfctl.rules.smoke.wheel_turns_backwards import wheel_turns_backwards
from urdfctl.smoke.mechanism import Body, Hinge, Mechanism
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.tasks import Drive, Family, Task

GRAVITY: Vector = (0.0, 0.0, -9.81)
LATERAL = 0.7
"""A wheel that drives forward has at least this much of its axis pointing sideways."""
MEASURES_DIFFER = 0.15
"""The accepted relative difference of a wheel's radius, or of the wheel separation, from the controller's parameter."""


def static_troubles(mechanism: Mechanism, tasks: Sequence[Task]) -> Iterator[Trouble]:
    """Yield what is wrong with a robot at rest, and with what its active controllers should move."""
    yield from _masses(mechanism)
    for task in tasks:
        if task.drive is not None:
            yield from _sides(mechanism, task, task.drive)
            yield from _axes(mechanism, task, task.drive)
            yield from _measures(mechanism, task, task.drive)
        elif task.rolling is not None:
            yield from _axes(mechanism, task, task.rolling)
        yield from _velocity_limits(mechanism, task)
    yield from _effort_limits(mechanism, tasks)


def _masses(mechanism: Mechanism) -> Iterator[Trouble]:
    for body in mechanism.bodies.values():
        numbers = (body.mass, *body.centre, *(moment for row in body.inertia for moment in row))
        problem = ""
        if not all(map(math.isfinite, numbers)):
            problem = "not a finite number"
        elif body.mass < 0 or any(body.inertia[n][n] < 0 for n in range(3)):
            problem = "negative"
        if problem:
            yield trouble_of(inertia_unusable, f"link:{body.name}", link=body.name, problem=problem)


# -- wheels ----------------------------------------------------------------------------------------------------------


def _wheels(mechanism: Mechanism, names: Sequence[str], drive: Drive) -> list[tuple[Hinge, Pose]]:
    """The wheels with some joint names, each with its pose in the base frame."""
    poses = mechanism.poses(mechanism.start())
    base = poses.get(drive.base, poses[mechanism.root])
    back = transposed(base.turn)
    wheels = []
    for hinge in (mechanism.hinge(name) for name in names):
        if hinge is not None:
            pose = poses[hinge.child]
            place = turned(back, minus(pose.place, base.place))
            wheels.append((hinge, Pose(place).then(Pose(turn=back)).then(Pose(turn=pose.turn))))
    return wheels


def _sides(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    left, right = _wheels(mechanism, drive.left, drive), _wheels(mechanism, drive.right, drive)
    if left and right and _across(left) < _across(right):
        note = "the robot turns right when commanded to turn left: swap the wheel names, or the signs of y"
        subject, names = f"controller:{task.controller}", {"left": left[0][0].name, "right": right[0][0].name}
        yield trouble_of(wheel_sides_swapped, subject, task.controller, (note,), **names)


def _across(wheels: Sequence[tuple[Hinge, Pose]]) -> float:
    """The mean distance of some wheels to the left, in m."""
    return sum(pose.place[1] for _, pose in wheels) / len(wheels)


def _axes(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    for hinge, pose in _wheels(mechanism, (*drive.left, *drive.right, *drive.driven), drive):
        axis = turned(pose.turn, hinge.axis)
        if axis[1] >= LATERAL:
            continue
        how = "backwards" if axis[1] <= -LATERAL else "about an axis that cannot roll it forward"
        shown = " ".join(f"{part:.2g}" for part in axis)
        note = f"its axis in the base frame is {shown}; a wheel that rolls forward turns about 0 1 0"
        subject = f"joint:{hinge.name}"
        yield trouble_of(wheel_turns_backwards, subject, task.controller, (note,), joint=hinge.name, how=how)


def _measures(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    wheels = _wheels(mechanism, (*drive.left, *drive.right, *drive.driven), drive)
    radii = {mechanism.bodies[hinge.child].radius for hinge, _ in wheels} - {None}
    if len(radii) == 1 and (real := radii.pop()) and _differ(drive.radius, real):
        yield _measure_differs(task, "radius", f"{drive.radius:g}", f"{real:g}")
    if len(drive.left) == 1 == len(drive.right) and len(wheels) == 2:  # noqa: PLR2004 (of more, the middle ones slip)
        apart = abs(wheels[0][1].place[1] - wheels[1][1].place[1])
        if _differ(drive.separation, apart):
            yield _measure_differs(task, "separation", f"{drive.separation:g}", f"{apart:.3g}")


def _measure_differs(task: Task, measure: str, expected: str, actual: str) -> Trouble:
    subject, fields = f"controller:{task.controller}", {"measure": measure, "expected": expected, "actual": actual}
    return trouble_of(wheel_measures_differ, subject, task.controller, (), **fields)


def _differ(given: float, real: float) -> bool:
    return given > 0 and real > 0 and abs(given / real - 1) > MEASURES_DIFFER


# -- joints ----------------------------------------------------------------------------------------------------------


def _velocity_limits(mechanism: Mechanism, task: Task) -> Iterator[Trouble]:
    for hinge in filter(None, map(mechanism.hinge, task.joints)):
        if hinge.velocity == 0 and hinge.moves:
            yield trouble_of(joint_held_still, f"joint:{hinge.name}", task.controller, joint=hinge.name)


def _effort_limits(mechanism: Mechanism, tasks: Sequence[Task]) -> Iterator[Trouble]:
    owners = {joint: task.controller for task in reversed(tasks) if task.drive is None for joint in task.joints}
    load = gravity_load(mechanism, mechanism.start())
    for name, controller in owners.items():
        hinge = mechanism.hinge(name)
        if hinge is None or hinge.mimic or not hinge.effort or not hinge.moves:
            continue
        needed = abs(load.get(name, 0.0))
        if needed > hinge.effort:
            fields = {"joint": name, "needed": needed, "unit": hinge.effort_unit, "limit": hinge.effort}
            yield trouble_of(effort_too_weak_for_gravity, f"joint:{name}", controller, (), **fields)


def gravity_load(mechanism: Mechanism, positions: Mapping[str, float]) -> dict[str, float]:
    """Return the effort of each hinge that holds the robot still, in N m or N, while its root is fixed."""
    poses = mechanism.poses(positions)
    weights = {name: _weight(body) for name, body in mechanism.bodies.items()}
    places = {name: poses[name].at(body.centre) for name, body in mechanism.bodies.items()}
    load = {}
    for hinge in mechanism.hinges:
        if not hinge.moves:
            continue
        pose = poses[hinge.child]
        axis = turned(pose.turn, hinge.axis)
        total = 0.0
        for link in mechanism.below(hinge.child):
            lever = cross(axis, minus(places[link], pose.place)) if hinge.type != "prismatic" else axis
            total -= dot(weights[link], lever)
        load[hinge.name] = total
    return load


def _weight(body: Body) -> Vector:
    mass = body.mass if body.falls else 0.0
    return GRAVITY[0] * mass, GRAVITY[1] * mass, GRAVITY[2] * mass


def is_loop(task: Task) -> bool:
    """Return whether a controller closes a control loop by commanding efforts."""
    closed = task.family in (Family.POSITION_PID, Family.VELOCITY_PID, Family.TRAJECTORY)
    return closed and task.interface == "effort"
