"""Robots on the ground that nothing fixes to the world: whether they stand while their joints are held."""

from __future__ import annotations

from urdfctl.smoke.engines import EngineSetup, RobotRejected, open_engine
from urdfctl.smoke.motion.motions import PidLoop
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.simulation import Exploded, OutOfTime, RobotSimulation
from urdfctl.smoke.robot import TIPPED, Hinge
from urdfctl.smoke.tasks import FREELY, Goal, MotionFamily, effort_of

STANDING = 1.0
"""The time for which a robot must stand, in s."""
SUNK = 0.3
"""A robot that sinks by this fraction of the height of its root above its feet does not stand."""
NUDGED = 0.02
"""The joints begin this far from where they are held, in rad: legs that are exactly straight would not bend."""


def why_not_standing(plan: MotionPlan, setup: EngineSetup, began: float) -> str:
    """Return why a robot does not stand in an engine while its joints are held, or an empty text."""
    try:
        start = {hinge.name: _nudged(hinge) for hinge in plan.mechanism.hinges if hinge.moves}
        engine = open_engine(plan.engine, setup._replace(urdf=plan.ground_urdf, fixed=False, start=start))
    except RobotRejected as refusal:
        return str(refusal)
    simulation = RobotSimulation(plan._replace(fixed=False), engine, began)
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


def _watched(simulation: RobotSimulation) -> str:
    engine, hinges = simulation.engine, simulation.hinges
    holding = [task for task in simulation.plan.tasks if task.is_loop and task.family is not MotionFamily.VELOCITY_PID]
    gains = {joint: gain for task in holding for joint, gain in zip(task.joints, task.gains, strict=True)}
    loops = {name: gain for name, gain in gains.items() if name in hinges}
    goals = [Goal(hinges[name], hinges[name].start, 0.0) for name in loops]
    motion = PidLoop(engine, goals, list(loops.values()), "effort", lambda goal, _: (goal.start, 0.0))
    for hinge in simulation.mechanism.movable:
        if hinge.name not in loops:
            engine.to_position(hinge.name, hinge.start, effort_of(hinge), FREELY)
    height = engine.base_pose().z
    for update in range(round(STANDING / simulation.period)):
        motion.update(update * simulation.period, simulation.period)
        simulation.update()
    now = engine.base_pose()
    if max(abs(now.roll), abs(now.pitch)) > TIPPED:
        return "it tips over while its joints are held"
    return "it sinks down while its joints are held" if now.z < (1 - SUNK) * height else ""
