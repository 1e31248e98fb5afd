"""Legged robots on the ground: whether they stand while their controllers hold their joints."""

from __future__ import annotations

from urdfctl.smoke.engines import Refused, Setup, open_engine
from urdfctl.smoke.ground import TIPPED, TOUCHING, resting
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.motions import FREELY, Goal, Loop, effort_of
from urdfctl.smoke.plan import Plan
from urdfctl.smoke.shapes import Shapes
from urdfctl.smoke.simulation import Exploded, OutOfTime, Simulation
from urdfctl.smoke.tasks import Family, is_loop

STANDING = 1.0
"""The time for which a robot must stand, in s."""
SUNK = 0.3
"""A robot that sinks by this fraction of the height of its root above its feet does not stand."""
LEAST_FEET = 2
NUDGED = 0.02
"""The joints begin this far from where they are held, in rad: legs that are exactly straight would not bend."""
HELD_IN_THE_AIR = "the base is held in the air"


def feet_of(mechanism: Mechanism, shapes: Shapes) -> tuple[str, ...]:
    """Return the links on which a legged robot rests with its joints held; none if it has no legs, or unknown shapes.

    Each foot is at the end of a leg of its own, which begins at the base and whose joints have limits.
    """
    at_rest = resting(mechanism, shapes) if shapes.complete and not mechanism.is_fixed else None
    if at_rest is None or at_rest.tilt > TIPPED:
        return ()
    feet = [name for name, height in at_rest.heights.items() if height <= TOUCHING]
    legs = {name: [hinge for hinge in mechanism.above(name) if hinge.moves] for name in feet}
    if not all(legs.values()) or any(hinge.type == "continuous" for leg in legs.values() for hinge in leg):
        return ()
    return tuple(feet) if len({leg[-1].name for leg in legs.values()}) >= LEAST_FEET else ()


def why_not_standing(plan: Plan, setup: Setup, began: float) -> str:
    """Return why a robot does not stand in an engine while its joints are held, or an empty text."""
    try:
        start = {hinge.name: _nudged(hinge) for hinge in plan.mechanism.hinges if hinge.moves}
        engine = open_engine(plan.engine, setup._replace(urdf=plan.standing, fixed=False, start=start))
    except Refused as refusal:
        return str(refusal)
    simulation = Simulation(plan._replace(fixed=False), engine, began)
    try:
        return _watched(simulation)
    except Exploded:
        return "the simulation explodes on the ground"
    except OutOfTime:
        return "too slow"
    finally:
        engine.close()


def _nudged(hinge: Hinge) -> float:
    if hinge.type == "prismatic":
        return hinge.start
    high = hinge.span[1]
    return hinge.start + (NUDGED if hinge.start + NUDGED <= high else -NUDGED if hinge.start == high else 0.0)


def _watched(simulation: Simulation) -> str:
    engine, hinges = simulation.engine, simulation.hinges
    holding = [task for task in simulation.plan.tasks if is_loop(task) and task.family is not Family.VELOCITY_PID]
    gains = {joint: gain for task in holding for joint, gain in zip(task.joints, task.gains, strict=True)}
    loops = {name: gain for name, gain in gains.items() if name in hinges}
    goals = [Goal(hinges[name], hinges[name].start, 0.0) for name in loops]
    motion = Loop(engine, goals, list(loops.values()), "effort", lambda goal, _: (goal.start, 0.0))
    for hinge in simulation.mechanism.movable:
        if hinge.name not in loops:
            engine.to_position(hinge.name, hinge.start, effort_of(hinge), FREELY)
    height = engine.standing().z
    for update in range(round(STANDING / simulation.period)):
        motion.update(update * simulation.period, simulation.period)
        simulation.update()
    now = engine.standing()
    if max(abs(now.roll), abs(now.pitch)) > TIPPED:
        return "it tips over while its joints are held"
    return "it sinks down while its joints are held" if now.z < (1 - SUNK) * height else ""
