"""The checks of effort limits, by formula: against the weight, friction, damping and inertia of each joint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.rules.smoke.effort_too_weak_for_gravity import effort_too_weak_for_gravity
from urdfctl.rules.smoke.effort_too_weak_in_a_pose import effort_too_weak_in_a_pose
from urdfctl.rules.smoke.effort_too_weak_to_move import effort_too_weak_to_move
from urdfctl.rules.smoke.joint_resists_its_motor import joint_resists_its_motor
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism, gravity_load, moved_inertias, worst_loads
from urdfctl.smoke.tasks import ControllerTask, goal_of

LEAST_MARGIN = 0.05
"""An effort limit should exceed the weight on its joint by at least this fraction of the limit."""
SLOWER = 0.5
"""A joint must reach this fraction of the highest speed that its motion takes."""
TIME = 2.0
"""The time that a motion takes, in s."""


def effort_troubles(mechanism: Mechanism, tasks: Sequence[ControllerTask]) -> Iterator[Trouble]:
    """Yield the joints whose effort limit is too low: for the weight on them, for their friction, or to move at all."""
    owners: dict[str, ControllerTask] = {}
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


def _margins(mechanism: Mechanism, hinges: Sequence[Hinge], owners: Mapping[str, ControllerTask]) -> Iterator[Trouble]:
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


# -- friction, damping and inertia -----------------------------------------------------------------------------------


def _motor(hinge: Hinge, task: ControllerTask, weight: float, inertia: float) -> Iterator[Trouble]:
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


def resisted(hinge: Hinge, task: ControllerTask, speed: float, weight: float = 0.0) -> Trouble:
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
