"""The controllers in simulation: at every update each of them commands its joints."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

from urdfctl.smoke.engines import Engine
from urdfctl.smoke.mechanism import Hinge
from urdfctl.smoke.tasks import Drive, Family, Gains, Task
from urdfctl.startup.hints import Protocol
from urdfctl.startup.records import NamedTuple

FREELY = 1e4
"""The effort and velocity of a joint whose limit is missing or 0, which in ROS-Industrial means unknown."""
PART_OF_SPAN = 0.1
"""A joint is moved by this fraction of its range at most."""
PART_OF_VELOCITY = 0.3
"""The mean velocity of a motion is at most this fraction of the limit. On a ramp the peak is three times as much."""
MOST_TURN, MOST_SHIFT = 0.2, 0.05
"""A joint is moved by this much at most, in rad and m."""
LEAST_COMMON = 0.001
"""A joint is moved within the range of its commands if that is at least this fraction of its own range."""
CRUISE = 0.2
"""The velocity that a velocity loop should hold, in rad/s or m/s."""
FORWARD, TURN = 0.3, 0.5
"""The command to a mobile base: 0.3 m/s forward, 0.5 rad/s to the left."""
PART_OF_SPEED = 0.9
"""A base is driven at this fraction of what its wheels can do at most."""
MOST_STEERING = 0.5
"""A base is steered by this angle at most, in rad."""
PUSH = 1.0
"""An effort interface is pushed with this at most in addition to the weight, in N m or N."""
PART_OF_EFFORT = 0.2
"""An effort interface is pushed with this fraction of its limit at most in addition to the weight."""


class Goal(NamedTuple):
    """The motion of one joint: its start, its step, and the effort that holds its weight, in N m or N."""

    hinge: Hinge
    start: float
    by: float
    weight: float = 0.0

    @property
    def end(self) -> float:
        """The target position."""
        return self.start + self.by


def goal_of(hinge: Hinge, start: float, weight: float, seconds: float) -> Goal:
    """Return a motion within the joint's limits and the range of its commands: towards the side with more room, and
    slow enough for its velocity limit in a number of seconds."""
    low, high = _common(hinge.span, hinge.range_of("position"))
    far = min(PART_OF_SPAN * (high - low), MOST_SHIFT if hinge.type == "prismatic" else MOST_TURN)
    if hinge.velocity:
        far = min(far, PART_OF_VELOCITY * hinge.velocity * seconds)
    return Goal(hinge, start, far if start + 1.1 * far <= high else -far, weight)


def _common(span: tuple[float, float], other: tuple[float, float]) -> tuple[float, float]:
    """The part of a span that is also in another one; the span if there is hardly any such part."""
    low, high = max(span[0], other[0]), min(span[1], other[1])
    return (low, high) if high - low > LEAST_COMMON * (span[1] - span[0]) else span


def fastest(drive: Drive, hinges: Iterable[Hinge | None]) -> float:
    """Return the highest speed of a base that the velocity limits of its wheels allow, in m/s."""
    limits = (h.velocity * abs(drive.radius_of(h.name)) for h in hinges if h and h.velocity)
    return min((limit for limit in limits if limit), default=math.inf)


def speed_of(drive: Drive, hinges: Iterable[Hinge | None]) -> float:
    """Return the speed at which a base is driven, in m/s: its controller and its wheels limit it."""
    return min(FORWARD, drive.speed, PART_OF_SPEED * fastest(drive, hinges))


def turning_of(drive: Drive, speed: float) -> float:
    """Return the rate at which a base is turned, in rad/s: its controller limits it."""
    of_wheels = 2 * speed / drive.separation if drive.separation else TURN
    return min(TURN, drive.turning, max(of_wheels, TURN if speed >= FORWARD else 0.0))


def effort_of(hinge: Hinge) -> float:
    """Return the effort limit of a joint."""
    return hinge.effort or FREELY


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


class Forward:
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
                extra = min(effort * PART_OF_EFFORT, PUSH)
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


class Loop:
    """A PID loop for each joint, towards a step or along a ramp, which commands a velocity or an effort."""

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


class Wheels:
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
        self._loop: Loop | None = None
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

    def close_loops(self, gains: Mapping[str, Gains], interface: str) -> None:
        """Turn wheels by a loop each, which holds their velocity by commanding an interface."""
        goals = [Goal(self._hinges[name], 0.0, 0.0) for name in gains]
        loops = list(gains.values())
        self._loop = Loop(self._engine, goals, loops, interface, self._reference, of_velocity=True)

    def _reference(self, goal: Goal, _: float) -> tuple[float, float]:
        return 0.0, self._speeds[goal.hinge.name]


def motion_of(engine: Engine, task: Task, goals: Sequence[Goal], duration: float) -> Motion:
    """Return the motion of a controller of joints."""
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
