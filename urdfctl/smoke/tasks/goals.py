"""The goals of a test motion: how far and how fast a controller moves its joints or its base, within all limits."""

from __future__ import annotations

import math
from collections.abc import Iterable

from urdfctl.smoke.robot import Hinge
from urdfctl.smoke.tasks.task import Drive
from urdfctl.startup.records import NamedTuple

MOTION = 2.0
"""The default time for which each controller moves its joints, in s; half of it for a controller without a loop."""
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


class Goal(NamedTuple):
    """The motion of one joint: its start, its step, and the effort that holds its weight, in N m or N.

    push: the greatest effort beside that with which it is pushed.
    """

    hinge: Hinge
    start: float
    by: float
    weight: float = 0.0
    push: float = math.inf

    @property
    def end(self) -> float:
        """The target position."""
        return self.start + self.by

    def times(self, part: float) -> Goal:
        """Return the motion with a part of its step."""
        return self._replace(by=part * self.by)


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
