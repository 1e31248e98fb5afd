"""What physics needs no engine for: on which side wheels are and which way they turn, what gravity asks of a joint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.smoke.mechanism import Body, Hinge, Mechanism
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.tasks import Drive, Family, Task
from urdfctl.smoke.vectors import Pose, Vector, cross, dot, minus, transposed, turned

GRAVITY: Vector = (0.0, 0.0, -9.81)
LATERAL = 0.7
"""How much of a wheel's axis must point sideways: less is no wheel that drives forward."""
MEASURES_DIFFER = 0.15
"""By which part a wheel's radius, or the distance of the wheels, may differ from what the controller is told."""
LEAST_MASS = 1e-6
"""Below this, in kg, simulators take a link to have no mass."""


def static_troubles(mechanism: Mechanism, tasks: Sequence[Task]) -> Iterator[Trouble]:
    """What can be told of a robot and of what its active controllers are to move."""
    yield from _masses(mechanism)
    for task in tasks:
        if task.drive is not None:
            yield from _sides(mechanism, task, task.drive)
            yield from _turning(mechanism, task, task.drive)
            yield from _measures(mechanism, task, task.drive)
        elif task.rolling is not None:
            yield from _turning(mechanism, task, task.rolling)
        yield from _still(mechanism, task)
    yield from _too_weak(mechanism, tasks)


def _masses(mechanism: Mechanism) -> Iterator[Trouble]:
    for body in mechanism.bodies.values():
        numbers = (body.mass, *body.centre, *(moment for row in body.inertia for moment in row))
        if not all(map(math.isfinite, numbers)):
            yield Trouble("UC910", f"link:{body.name}", f"link '{body.name}' has a mass or inertia that is no number")
        elif body.mass < 0 or any(body.inertia[n][n] < 0 for n in range(3)):
            yield Trouble("UC910", f"link:{body.name}", f"link '{body.name}' has a negative mass or inertia")


# -- wheels ----------------------------------------------------------------------------------------------------------


def _wheels(mechanism: Mechanism, names: Sequence[str], drive: Drive) -> list[tuple[Hinge, Pose]]:
    """The wheels of some names, each with its pose in the frame of the base."""
    poses = mechanism.poses(mechanism.start())
    base = poses.get(drive.base, poses[mechanism.root])
    back = transposed(base.turn)
    found = []
    for hinge in (mechanism.hinge(name) for name in names):
        if hinge is not None:
            pose = poses[hinge.child]
            found.append(
                (
                    hinge,
                    Pose(turned(back, minus(pose.place, base.place))).then(Pose(turn=back)).then(Pose(turn=pose.turn)),
                )
            )
    return found


def _sides(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    left, right = _wheels(mechanism, drive.left, drive), _wheels(mechanism, drive.right, drive)
    if left and right and _across(left) < _across(right):
        names = f"'{left[0][0].name}' is on the right side and '{right[0][0].name}' on the left"
        message = f"controller '{task.controller}' takes the right wheels for the left ones: {names}"
        notes = ("told to turn left, the robot turns right: exchange the names of the wheels, or the signs of y",)
        yield Trouble("UC911", f"controller:{task.controller}", message, task.controller, notes)


def _across(wheels: Sequence[tuple[Hinge, Pose]]) -> float:
    """How far to the left some wheels are, in m."""
    return sum(pose.place[1] for _, pose in wheels) / len(wheels)


def _turning(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    for hinge, pose in _wheels(mechanism, (*drive.left, *drive.right, *drive.driven), drive):
        axis = turned(pose.turn, hinge.axis)
        if axis[1] >= LATERAL:
            continue
        what = "backwards" if axis[1] <= -LATERAL else "about an axis on which it cannot roll forward"
        told = " ".join(f"{part:.2g}" for part in axis)
        message = f"told to drive forward, controller '{task.controller}' turns wheel '{hinge.name}' {what}"
        notes = (f"seen from the base its axis is {told}; a wheel that rolls forward turns about 0 1 0",)
        yield Trouble("UC912", f"joint:{hinge.name}", message, task.controller, notes)


def _measures(mechanism: Mechanism, task: Task, drive: Drive) -> Iterator[Trouble]:
    wheels = _wheels(mechanism, (*drive.left, *drive.right, *drive.driven), drive)
    radii = {mechanism.bodies[hinge.child].radius for hinge, _ in wheels} - {None}
    if len(radii) == 1 and (real := radii.pop()) and _differ(drive.radius, real):
        message = (
            f"controller '{task.controller}' is told wheels of radius {drive.radius:g} m, and they have {real:g} m"
        )
        yield Trouble("UC913", f"controller:{task.controller}", message, task.controller)
    if len(drive.left) == 1 == len(drive.right) and len(wheels) == 2:  # noqa: PLR2004 (of more the middle slips)
        apart = abs(wheels[0][1].place[1] - wheels[1][1].place[1])
        if _differ(drive.separation, apart):
            told = f"wheels {drive.separation:g} m apart, and they are {apart:.3g} m"
            message = f"controller '{task.controller}' is told {told}"
            yield Trouble("UC913", f"controller:{task.controller}", message, task.controller)


def _differ(told: float, real: float) -> bool:
    return told > 0 and real > 0 and abs(told / real - 1) > MEASURES_DIFFER


# -- joints ----------------------------------------------------------------------------------------------------------


def _still(mechanism: Mechanism, task: Task) -> Iterator[Trouble]:
    for hinge in filter(None, map(mechanism.hinge, task.joints)):
        if hinge.velocity == 0 and hinge.moves:
            message = f"controller '{task.controller}' is to move joint '{hinge.name}', whose velocity limit is 0"
            yield Trouble("UC914", f"joint:{hinge.name}", message, task.controller)


def _too_weak(mechanism: Mechanism, tasks: Sequence[Task]) -> Iterator[Trouble]:
    owners = {joint: task.controller for task in reversed(tasks) if task.drive is None for joint in task.joints}
    load = gravity_load(mechanism, mechanism.start())
    for name, controller in owners.items():
        hinge = mechanism.hinge(name)
        if hinge is None or hinge.mimic or not hinge.effort or not hinge.moves:
            continue
        asked, unit = abs(load.get(name, 0.0)), "N" if hinge.type == "prismatic" else "N m"
        if asked > hinge.effort:
            message = (
                f"joint '{name}' needs {asked:.3g} {unit} to hold the robot at spawn, and its effort limit is "
                f"{hinge.effort:g} {unit}"
            )
            yield Trouble("UC915", f"joint:{name}", message, controller)


def gravity_load(mechanism: Mechanism, positions: Mapping[str, float]) -> dict[str, float]:
    """What each hinge must give to hold the robot still, in N m or N, where the root is fixed."""
    poses = mechanism.poses(positions)
    weights = {name: _weight(body) for name, body in mechanism.bodies.items()}
    places = {name: poses[name].at(body.centre) for name, body in mechanism.bodies.items()}
    found = {}
    for hinge in mechanism.hinges:
        if not hinge.moves:
            continue
        pose = poses[hinge.child]
        axis = turned(pose.turn, hinge.axis)
        total = 0.0
        for link in mechanism.below(hinge.child):
            lever = cross(axis, minus(places[link], pose.place)) if hinge.type != "prismatic" else axis
            total -= dot(weights[link], lever)
        found[hinge.name] = total
    return found


def _weight(body: Body) -> Vector:
    mass = body.mass if body.falls else 0.0
    return GRAVITY[0] * mass, GRAVITY[1] * mass, GRAVITY[2] * mass


def is_loop(task: Task) -> bool:
    """Whether a controller closes a loop over efforts."""
    closed = task.family in (Family.POSITION_PID, Family.VELOCITY_PID, Family.TRAJECTORY)
    return closed and task.interface == "effort"
