"""The tasks of a user in an engine: joints follow a path, wheels turn, and a base drives; then the end is compared."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.rules.smoke.task_not_performed import task_not_performed
from urdfctl.smoke.motion.checks import SLIPPING, Track, limit_troubles
from urdfctl.smoke.motion.mobile_base import (
    MotionOutcome,
    facing_of,
    stop_wheels,
    wheel_motion_of,
    with_measured_wheels,
)
from urdfctl.smoke.motion.motions import Motion, PidLoop, hold
from urdfctl.smoke.motion.simulation import RobotSimulation
from urdfctl.smoke.results import Curve, Trouble, trouble_of
from urdfctl.smoke.tasks import FREELY, ControllerTask, Drive, Goal, MotionFamily, UserTask, effort_of
from urdfctl.startup.records import NamedTuple

HOLDING = 0.5
"""The time in which a joint settles after the last point, in s."""
TOLERANCES = {"target": 0.02, "trajectory": 0.02, "velocity": 0.1, "drive": 0.1}
"""How far the end may be off if the file does not say, in rad, m, rad/s or m/s."""
ANGLE = 0.2
"""How far the direction of a base may be off if the file does not say, in rad."""


def perform_task(simulation: RobotSimulation, task: ControllerTask, user_task: UserTask) -> MotionOutcome:
    """Return what happens when a controller performs a task of the user."""
    return _driven(simulation, task, user_task) if user_task.kind == "drive" else _moved(simulation, task, user_task)


def _trouble(user_task: UserTask, what: str) -> Trouble:
    return trouble_of(task_not_performed, user_task.subject, user_task.controller, what=what)


def _tolerance(user_task: UserTask) -> float:
    return TOLERANCES[user_task.kind] if user_task.tolerance is None else user_task.tolerance


# -- joints ----------------------------------------------------------------------------------------------------------


def reference(user_task: UserTask, start: float, joint: str, seconds: float) -> tuple[float, float]:
    """Return the position and velocity that a joint should have: it stops at each point, and moves smoothly between.

    start: its position when the task begins, in rad or m.
    seconds: the time since then.
    """
    before, began = start, 0.0
    for step in user_task.steps:
        after = dict(step.values).get(joint, before)
        if seconds < step.until:
            part, whole = (seconds - began) / (step.until - began), step.until - began
            way = after - before
            return before + part * part * (3 - 2 * part) * way, 6 * part * (1 - part) * way / whole
        before, began = after, step.until
    return before, 0.0


def rate(user_task: UserTask, joint: str, seconds: float) -> float:
    """Return the velocity that a joint should have: it rises evenly until it should be reached, and is then held."""
    step = user_task.steps[0]
    return dict(step.values).get(joint, 0.0) * min(1.0, seconds / step.until)


class _CommandedTask:
    """Joints that get positions or velocities as commands, without a loop."""

    def __init__(self, simulation: RobotSimulation, goals: Sequence[Goal], user_task: UserTask) -> None:
        self._engine, self._goals, self._user_task = simulation.engine, goals, user_task
        self._targets = [goal.start for goal in goals]

    def update(self, seconds: float, period: float) -> None:  # noqa: ARG002 (it keeps no state)
        for index, goal in enumerate(self._goals):
            hinge, effort = goal.hinge, effort_of(goal.hinge)
            if self._user_task.kind == "velocity":
                self._targets[index] = rate(self._user_task, hinge.name, seconds)
                self._engine.at_velocity(hinge.name, self._targets[index], effort)
            else:
                self._targets[index], _ = reference(self._user_task, goal.start, hinge.name, seconds)
                self._engine.to_position(hinge.name, self._targets[index], effort, hinge.velocity or FREELY)

    def wanted(self, index: int) -> float:
        return self._targets[index]


def _motion(simulation: RobotSimulation, task: ControllerTask, goals: Sequence[Goal], user_task: UserTask) -> Motion:
    if task.family is MotionFamily.FORWARD or task.interface == "position":
        return _CommandedTask(simulation, goals, user_task)
    if user_task.kind == "velocity":
        return PidLoop(
            simulation.engine,
            goals,
            task.gains,
            task.interface,
            lambda goal, seconds: (0.0, rate(user_task, goal.hinge.name, seconds)),
            of_velocity=True,
        )
    return PidLoop(
        simulation.engine,
        goals,
        task.gains,
        task.interface,
        lambda goal, seconds: reference(user_task, goal.start, goal.hinge.name, seconds),
    )


def _moved(simulation: RobotSimulation, task: ControllerTask, user_task: UserTask) -> MotionOutcome:
    engine = simulation.engine
    goals = [Goal(simulation.hinges[name], engine.position(name), 0.0) for name in task.joints]
    motion = _motion(simulation, task, goals, user_task)
    [tracks] = simulation.tracked([(motion, goals)], user_task.seconds + HOLDING)
    named = {name for step in user_task.steps for name, _ in step.values}
    troubles: list[Trouble] = []
    curves: list[Curve] = []
    of_velocity = user_task.kind == "velocity"
    for goal, track in zip(goals, tracks, strict=True):
        name = goal.hinge.name
        if name in named:
            troubles += limit_troubles(task, goal, track)
            held = round(HOLDING / simulation.period)
            troubles += _of_velocity(user_task, goal, track, held) if of_velocity else _of_path(user_task, goal, track)
        quantity, measured = ("velocity", track.velocities) if of_velocity else ("position", track.positions)
        end, slack = track.wanted[-1], _tolerance(user_task)
        curves.append(
            simulation.curve(
                task.controller,
                name,
                quantity,
                track.wanted,
                measured,
                efforts=track.efforts,
                band=(end - slack, end + slack) if name in named else None,
            )
        )
        hold(engine, goal.hinge, engine.position(name))
    simulation.run_for(0.1)
    return MotionOutcome(tuple(troubles), tuple(curves))


def _of_path(user_task: UserTask, goal: Goal, track: Track) -> Iterator[Trouble]:
    tolerance, unit, name = _tolerance(user_task), goal.hinge.unit, goal.hinge.name
    end, wanted = track.positions[-1], track.wanted[-1]
    if abs(end - wanted) > tolerance:
        yield _trouble(user_task, f"joint '{name}' ends at {end:.4g} {unit}, not at {wanted:g} ± {tolerance:g} {unit}")
    most = max(abs(did - should) for did, should in zip(track.positions, track.wanted, strict=True))
    if user_task.path_tolerance is not None and most > user_task.path_tolerance:
        what = (
            f"joint '{name}' is up to {most:.3g} {unit} off its path; {user_task.path_tolerance:g} {unit} are allowed"
        )
        yield _trouble(user_task, what)


def _of_velocity(user_task: UserTask, goal: Goal, track: Track, held: int) -> Iterator[Trouble]:
    """The fault of a joint whose mean velocity in the last updates, while it is held, is not the one asked for."""
    last = track.velocities[-max(1, held) :]
    mean, wanted, tolerance = sum(last) / len(last), track.wanted[-1], _tolerance(user_task)
    if abs(mean - wanted) > tolerance:
        unit = f"{goal.hinge.unit}/s"
        what = f"joint '{goal.hinge.name}' ends at {mean:.4g} {unit}, not at {wanted:g} ± {tolerance:g} {unit}"
        yield _trouble(user_task, what)


# -- mobile bases ----------------------------------------------------------------------------------------------------


class Odometry(NamedTuple):
    """The place of a base, from where it started and in the direction that it faced then, in m and rad.

    way: the length of the way there, in m.
    """

    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    way: float = 0.0

    def on(self, distance: float, angle: float) -> Odometry:
        """Return where it is after a short arc."""
        facing = self.yaw + angle / 2
        x, y = self.x + distance * math.cos(facing), self.y + distance * math.sin(facing)
        return Odometry(x, y, self.yaw + angle, self.way + abs(distance))


def _driven(simulation: RobotSimulation, task: ControllerTask, user_task: UserTask) -> MotionOutcome:
    drive = with_measured_wheels(simulation.mechanism, task.drive or Drive())
    engine, period = simulation.engine, simulation.period
    first = last = engine.base_pose()
    facing = first.yaw + facing_of(simulation.mechanism, drive)
    should, yaw, began = Odometry(), 0.0, 0.0
    wanted, did = [], []
    for step in user_task.steps:
        speeds: Mapping[str, float] = dict(step.values)
        wheels = wheel_motion_of(simulation, task, drive, speeds.get("forward", 0.0), speeds.get("turn", 0.0))
        for update in range(max(1, round((step.until - began) / period))):
            before = wheels.distance, wheels.angle
            wheels.update(update * period, period)
            simulation.update()
            should = should.on(wheels.distance - before[0], wheels.angle - before[1])
            now = engine.base_pose()
            yaw += (now.yaw - last.yaw + math.pi) % (2 * math.pi) - math.pi
            last = now
            wanted.append(math.hypot(should.x, should.y))
            did.append(math.hypot(now.x - first.x, now.y - first.y))
        began = step.until
    stop_wheels(simulation, drive)
    x, y = last.x - first.x, last.y - first.y
    ahead = x * math.cos(facing) + y * math.sin(facing)
    aside = y * math.cos(facing) - x * math.sin(facing)
    actual = Odometry(ahead, aside, yaw)
    curve = simulation.curve(task.controller, "base", "distance", wanted, did)
    slack = SLIPPING if simulation.plan.engine == "mujoco" else 0.0
    return MotionOutcome(tuple(_of_base(user_task, drive, should, actual, slack)), (curve,))


def _of_base(user_task: UserTask, drive: Drive, should: Odometry, actual: Odometry, slack: float) -> Iterator[Trouble]:
    """The faults of a drive. How far wheels slip in a turn is not known: without tolerances it is not judged.

    `slack` is the part of the way by which an engine lets wheels slip.
    """
    slips = drive.is_skidding and abs(should.yaw) > ANGLE
    off = math.hypot(actual.x - should.x, actual.y - should.y)
    if off > _tolerance(user_task) + slack * should.way and not (slips and user_task.tolerance is None):
        places = f"({actual.x:.2f}, {actual.y:.2f}) m, not at ({should.x:.2f}, {should.y:.2f}) m"
        yield _trouble(user_task, f"the base ends at {places} ± {_tolerance(user_task):g} m")
    tolerance = ANGLE if user_task.angle_tolerance is None else user_task.angle_tolerance
    if abs(actual.yaw - should.yaw) > tolerance + slack * abs(should.yaw) and not (
        slips and user_task.angle_tolerance is None
    ):
        what = f"the base turns by {actual.yaw:.2f} rad, not by {should.yaw:.2f} ± {tolerance:g} rad"
        yield _trouble(user_task, what)
