"""The controllers in simulation: at every update each of them commands its joints."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from urdfctl.smoke.engines import Engine
from urdfctl.smoke.robot import Hinge
from urdfctl.smoke.tasks import CRUISE, FREELY, ControllerTask, Drive, Goal, MotionFamily, PidGains, effort_of

MOST_STEERING = 0.5
"""A base is steered by this angle at most, in rad."""
PUSH = 1.0
"""An effort interface is pushed with this at most in addition to the weight and the friction, in N m or N."""
PART_OF_EFFORT = 0.2
"""An effort interface is pushed with this fraction of its limit at most in addition to the weight and the friction."""


def hold(engine: Engine, hinge: Hinge, position: float) -> None:
    """Hold a joint at a position with its motor."""
    engine.to_position(hinge.name, position, FREELY, FREELY)


class Motion(Protocol):
    """The way a controller commands its joints."""

    def update(self, seconds: float, period: float) -> None:
        """Command the joints, some seconds after activation; the next update comes a period later."""
        raise NotImplementedError

    def wanted(self, index: int) -> float:
        """Return the last target of a joint, in the quantity by which it is judged."""
        raise NotImplementedError


class ForwardMotion:
    """A controller that forwards its command to the joints."""

    def __init__(self, engine: Engine, goals: Sequence[Goal], interface: str, duration: float) -> None:
        self._engine, self._goals, self._interface, self._duration = engine, goals, interface, duration
        self._targets = [goal.start for goal in goals]

    def update(self, seconds: float, period: float) -> None:  # noqa: ARG002 (it keeps no state)
        """Command a ramp of positions, or a step of velocity or effort."""
        for index, goal in enumerate(self._goals):
            name, effort = goal.hinge.name, effort_of(goal.hinge)
            if self._interface == "position":
                self._targets[index] = ramp(goal, seconds, self._duration)
                self._engine.to_position(name, self._targets[index], effort, goal.hinge.velocity or FREELY)
            elif self._interface == "velocity":
                self._targets[index] = goal.by / self._duration
                self._engine.at_velocity(name, self._targets[index], effort)
            else:
                extra = min(goal.hinge.friction + min(effort * PART_OF_EFFORT, PUSH), goal.push)
                self._targets[index] = max(-effort, min(effort, goal.weight + math.copysign(extra, goal.by)))
                self._engine.with_effort(name, self._targets[index])

    def wanted(self, index: int) -> float:
        """Return the last command."""
        return self._targets[index]


def ramp(goal: Goal, seconds: float, duration: float) -> float:
    """Return the position on a smooth ramp that ends at half of the duration."""
    part = min(1.0, seconds / (duration * 0.5))
    return goal.start + part * part * (3 - 2 * part) * goal.by


def ramp_velocity(goal: Goal, seconds: float, duration: float) -> float:
    """Return the velocity on the ramp."""
    half = duration * 0.5
    part = min(1.0, seconds / half)
    return 6 * part * (1 - part) / half * goal.by


class PidLoop:
    """A PID loop for each joint, towards a step or along a ramp, which commands a velocity or an effort."""

    def __init__(
        self,
        engine: Engine,
        goals: Sequence[Goal],
        gains: Sequence[PidGains],
        interface: str,
        reference: Callable[[Goal, float], tuple[float, float]],
        *,
        of_velocity: bool = False,
    ) -> None:
        self._engine, self._goals, self._gains, self._interface = engine, goals, gains, interface
        self._reference, self._of_velocity = reference, of_velocity
        self._sums = [0.0] * len(goals)
        self._before: list[float | None] = [None] * len(goals)
        self._targets = [goal.start for goal in goals]

    def update(self, seconds: float, period: float) -> None:
        """Update each loop once."""
        for index, (goal, gain) in enumerate(zip(self._goals, self._gains, strict=True)):
            name = goal.hinge.name
            position, velocity = self._reference(goal, seconds)
            if self._of_velocity:
                self._targets[index] = velocity
                error = velocity - self._engine.velocity(name)
                before = self._before[index]
                rate = 0.0 if before is None else (error - before) / period
                self._before[index] = error
            else:
                self._targets[index] = position
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
        """Return the last reference."""
        return self._targets[index]


class WheelMotion:
    """A mobile base with a commanded velocity: forward in m/s, and turning left in rad/s.

    `sides` holds the distance of each wheel to the left of the base, in m. `distance` and `angle` are what was
    commanded so far, in m and rad.
    """

    def __init__(
        self,
        engine: Engine,
        hinges: Mapping[str, Hinge],
        drive: Drive,
        forward: float,
        turning: float,
        sides: Mapping[str, float],
    ) -> None:
        self._engine, self._hinges, self._drive, self._sides = engine, hinges, drive, sides
        self._forward, self._turning = forward, turning
        self._speeds: dict[str, float] = {}
        self._loop: PidLoop | None = None
        self.distance = self.angle = 0.0
        if drive.steered and forward and turning:
            steering = math.atan(turning * drive.wheelbase / forward)
            steering = max(-MOST_STEERING, min(MOST_STEERING, steering))
            self._turning = forward * math.tan(steering) / drive.wheelbase

    def update(self, seconds: float, period: float) -> None:
        """Command all wheels; the speed rises as fast as the controller allows."""
        drive = self._drive
        fastest = max(abs(self._forward), abs(self._turning) * max(drive.separation, drive.wheelbase) / 2)
        part = min(1.0, drive.acceleration * (seconds + period) / fastest) if fastest else 1.0
        forward, turning = self._forward * part, self._turning * part
        self.distance += forward * period
        self.angle += turning * period
        aside = turning * drive.separation / 2
        speeds = {
            **dict.fromkeys(drive.left, forward - aside),
            **dict.fromkeys(drive.right, forward + aside),
            **{name: forward - turning * self._sides.get(name, 0.0) for name in drive.driven},
        }
        self._speeds = {name: speed / drive.radius_of(name) for name, speed in speeds.items()}
        if self._loop:
            self._loop.update(seconds, period)
        for name, rate in self._speeds.items() if not self._loop else ():
            self._engine.at_velocity(name, rate, effort_of(self._hinges[name]))
        for name in drive.steered:
            ahead = self._forward - self._turning * self._sides.get(name, 0.0)
            steering = math.atan(self._turning * drive.wheelbase / ahead) if self._turning else 0.0
            self._engine.to_position(name, steering, effort_of(self._hinges[name]), FREELY)

    def close_loops(self, gains: Mapping[str, PidGains], interface: str) -> None:
        """Turn wheels by a loop each, which holds their velocity by commanding an interface."""
        goals = [Goal(self._hinges[name], 0.0, 0.0) for name in gains]
        loops = list(gains.values())
        self._loop = PidLoop(self._engine, goals, loops, interface, self._reference, of_velocity=True)

    def _reference(self, goal: Goal, _: float) -> tuple[float, float]:
        return 0.0, self._speeds[goal.hinge.name]


def motion_of(engine: Engine, task: ControllerTask, goals: Sequence[Goal], duration: float) -> Motion:
    """Return the motion of a controller of joints."""
    if task.family is MotionFamily.VELOCITY_PID:
        return PidLoop(
            engine,
            goals,
            task.gains,
            task.interface,
            lambda goal, _: (0.0, math.copysign(CRUISE, goal.by)),
            of_velocity=True,
        )
    if task.family is MotionFamily.POSITION_PID and task.interface != "position":
        return PidLoop(engine, goals, task.gains, task.interface, lambda goal, _: (goal.end, 0.0))
    if task.family is MotionFamily.TRAJECTORY and task.interface != "position":
        return PidLoop(
            engine,
            goals,
            task.gains,
            task.interface,
            lambda goal, seconds: (ramp(goal, seconds, duration), ramp_velocity(goal, seconds, duration)),
        )
    return ForwardMotion(engine, goals, task.interface, duration)
