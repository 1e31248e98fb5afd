"""The controllers as the engines see them: each tells, at every update, its joints what to do."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from urdfctl.record import NamedTuple
from urdfctl.smoke.engines import Engine
from urdfctl.smoke.mechanism import Hinge
from urdfctl.smoke.tasks import Drive, Family, Gains, Task

FREELY = 1e4
"""The effort and the velocity of what has no limit, or one of 0: ROS-Industrial's way of saying it is not known."""
PART_OF_SPAN = 0.1
PART_OF_VELOCITY = 0.3
"""Of its velocity limit, what it needs on the mean of its way: on a ramp three times as much at the fastest."""
MOST_TURN, MOST_SHIFT = 0.2, 0.05
"""How far a joint is moved: a tenth of where it may be, and no more than this, in rad and m."""
CRUISE = 0.2
"""The velocity that a velocity loop is told to hold, in rad/s or m/s."""
PUSH = 1.0
PART_OF_EFFORT = 0.2
"""How hard an effort interface is pushed beside the weight: a fifth of its limit, and no more than this (N m, N)."""


class Goal(NamedTuple):
    """What one joint is to do: from where, how far, and what it needs to hold its weight, in N m or N."""

    hinge: Hinge
    start: float
    by: float
    weight: float = 0.0

    @property
    def end(self) -> float:
        """Where it is to be in the end."""
        return self.start + self.by


def goal_of(hinge: Hinge, start: float, weight: float, seconds: float) -> Goal:
    """A motion of a joint that stays where it may be, towards the side with more room, and that its velocity limit
    lets it make in some time."""
    low, high = hinge.span
    far = min(PART_OF_SPAN * (high - low), MOST_SHIFT if hinge.type == "prismatic" else MOST_TURN)
    if hinge.velocity:
        far = min(far, PART_OF_VELOCITY * hinge.velocity * seconds)
    return Goal(hinge, start, far if start + 1.1 * far <= high else -far, weight)


def effort_of(hinge: Hinge) -> float:
    """What a joint can give."""
    return hinge.effort or FREELY


def hold(engine: Engine, hinge: Hinge, position: float) -> None:
    """Keep a joint where it is, by its motor."""
    engine.to_position(hinge.name, position, FREELY, FREELY)


class Motion(Protocol):
    """What a controller does with its joints."""

    def update(self, seconds: float, period: float) -> None:
        """Tell the joints what to do, some seconds after it was activated; the next update comes a period later."""
        raise NotImplementedError

    def wanted(self, index: int) -> float:
        """What it last wanted of a joint, in the quantity that it is judged by."""
        raise NotImplementedError


class Forward:
    """The command goes to the joints as it is."""

    def __init__(self, engine: Engine, goals: Sequence[Goal], interface: str, duration: float) -> None:
        self._engine, self._goals, self._interface, self._duration = engine, goals, interface, duration
        self._told = [goal.start for goal in goals]

    def update(self, seconds: float, period: float) -> None:  # noqa: ARG002 (it has no memory)
        """Positions follow a ramp, velocities and efforts are steps."""
        for index, goal in enumerate(self._goals):
            name, effort = goal.hinge.name, effort_of(goal.hinge)
            if self._interface == "position":
                self._told[index] = ramp(goal, seconds, self._duration)
                self._engine.to_position(name, self._told[index], effort, goal.hinge.velocity or FREELY)
            elif self._interface == "velocity":
                self._told[index] = goal.by / self._duration
                self._engine.at_velocity(name, self._told[index], effort)
            else:
                extra = min(effort * PART_OF_EFFORT, PUSH)
                self._told[index] = max(-effort, min(effort, goal.weight + math.copysign(extra, goal.by)))
                self._engine.with_effort(name, self._told[index])

    def wanted(self, index: int) -> float:
        """The last command."""
        return self._told[index]


def ramp(goal: Goal, seconds: float, duration: float) -> float:
    """The position on the way: smooth, and there at half time."""
    part = min(1.0, seconds / (duration * 0.5))
    return goal.start + part * part * (3 - 2 * part) * goal.by


def ramp_velocity(goal: Goal, seconds: float, duration: float) -> float:
    """The velocity on the way."""
    half = duration * 0.5
    part = min(1.0, seconds / half)
    return 6 * part * (1 - part) / half * goal.by


class Loop:
    """A PID loop for each joint, towards a step or along a ramp, whose output is a velocity or an effort."""

    def __init__(
        self,
        engine: Engine,
        goals: Sequence[Goal],
        gains: Sequence[Gains],
        interface: str,
        reference: Callable[[Goal, float], tuple[float, float]],
        *,
        of_velocity: bool = False,
    ) -> None:
        self._engine, self._goals, self._gains, self._interface = engine, goals, gains, interface
        self._reference, self._of_velocity = reference, of_velocity
        self._sums = [0.0] * len(goals)
        self._before: list[float | None] = [None] * len(goals)
        self._told = [goal.start for goal in goals]

    def update(self, seconds: float, period: float) -> None:
        """One update of each loop."""
        for index, (goal, gain) in enumerate(zip(self._goals, self._gains, strict=True)):
            name = goal.hinge.name
            position, velocity = self._reference(goal, seconds)
            if self._of_velocity:
                self._told[index] = velocity
                error = velocity - self._engine.velocity(name)
                before = self._before[index]
                rate = 0.0 if before is None else (error - before) / period
                self._before[index] = error
            else:
                self._told[index] = position
                error = position - self._engine.position(name)
                rate = velocity - self._engine.velocity(name)
            self._sums[index] = max(-gain.clamp, min(gain.clamp, self._sums[index] + gain.i * error * period))
            output = gain.p * error + self._sums[index] + gain.d * rate
            self._send(goal.hinge, output + gain.feed * velocity)

    def _send(self, hinge: Hinge, output: float) -> None:
        most = effort_of(hinge)
        if not math.isfinite(output):
            output = 0.0
        if self._interface == "velocity":
            bound = hinge.velocity or FREELY
            self._engine.at_velocity(hinge.name, max(-bound, min(bound, output)), most)
        else:
            self._engine.with_effort(hinge.name, max(-most, min(most, output)))

    def wanted(self, index: int) -> float:
        """The last reference."""
        return self._told[index]


class Wheels:
    """A mobile base: told how fast to go forward, in m/s, and how fast to turn left, in rad/s."""

    def __init__(
        self, engine: Engine, hinges: Mapping[str, Hinge], drive: Drive, forward: float, turning: float
    ) -> None:
        self._engine, self._hinges, self._drive = engine, hinges, drive
        self._forward, self._turning = forward, turning
        self.steering = math.atan(turning * drive.wheelbase / forward) if forward and drive.steered else 0.0
        self.steering = max(-0.5, min(0.5, self.steering))

    def update(self, seconds: float, period: float) -> None:  # noqa: ARG002 (the command does not change)
        """The commands of all wheels."""
        drive = self._drive
        aside = self._turning * drive.separation / 2
        for names, speed in (
            (drive.left, self._forward - aside),
            (drive.right, self._forward + aside),
            (drive.driven, self._forward),
        ):
            for name in names:
                self._engine.at_velocity(name, speed / drive.radius, effort_of(self._hinges[name]))
        for name in drive.steered:
            self._engine.to_position(name, self.steering, effort_of(self._hinges[name]), FREELY)

    def wanted(self, index: int) -> float:
        """How fast it is to go forward."""
        return self._forward if index == 0 else self._turning


def motion_of(engine: Engine, task: Task, goals: Sequence[Goal], duration: float) -> Motion:
    """What a controller of joints does."""
    if task.family is Family.VELOCITY_PID:
        return Loop(
            engine,
            goals,
            task.gains,
            task.interface,
            lambda goal, _: (0.0, math.copysign(CRUISE, goal.by)),
            of_velocity=True,
        )
    if task.family is Family.POSITION_PID and task.interface != "position":
        return Loop(engine, goals, task.gains, task.interface, lambda goal, _: (goal.end, 0.0))
    if task.family is Family.TRAJECTORY and task.interface != "position":
        return Loop(
            engine,
            goals,
            task.gains,
            task.interface,
            lambda goal, seconds: (ramp(goal, seconds, duration), ramp_velocity(goal, seconds, duration)),
        )
    return Forward(engine, goals, task.interface, duration)
