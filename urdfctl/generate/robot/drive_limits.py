"""The limits of a drive on two rows of wheels, from the limits of its wheels."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.robot.wheels import across, along, radius
from urdfctl.startup.records import NamedTuple

_IN = 0.5
"""The time, in s, in which a drive reaches its greatest speed if the efforts of its wheels are unknown."""
_GRIP = 4.0
"""The greatest acceleration, in m/s2, that rubber wheels on a floor can give."""
_PART_OF_EFFORT = 0.5
_KINDS = ("speed", "push", "turn", "spin")
DRIVE_LIMITS = tuple(f"{sign}_{kind}" for kind in _KINDS for sign in ("max", "min", "true_if"))
"""The names of the limits in recipes: forward speed and acceleration, turning speed and acceleration."""


class DriveLimit(NamedTuple):
    """A limit in m/s, m/s2, rad/s or rad/s2, and how it was determined."""

    value: float
    how: str


def drive_limit(
    kind: str, left: Sequence[JointFacts], right: Sequence[JointFacts], *, sideways: bool = False
) -> DriveLimit | None:
    """Return a limit of a drive, or None if the robot does not determine it.

    sideways: True for mecanum wheels, which turn the robot with the sum of half the track width and half the wheelbase
    as lever.
    """
    wheels = (*left, *right)
    wheel, apart = radius(wheels).value, across(left, right).value
    length = along((left[0], right[0]), (left[-1], right[-1])).value if sideways and left and right else None
    lever = (apart + (length or 0.0)) / 2 if apart else None
    fastest = [joint.velocity for joint in wheels if joint.velocity]
    if not wheel or not fastest:
        return None
    speed, how = min(fastest) * wheel, "velocity limit of the wheels times their radius"
    if kind == "speed":
        return DriveLimit(round(speed, 3), how)
    push, why = _push(wheels, wheel, speed)
    if kind == "push":
        return DriveLimit(_short(push), why)
    if not lever:
        return None
    if kind == "turn":
        return DriveLimit(_short(speed / lever), "both rows of wheels at their velocity limit")
    return DriveLimit(_short(push / lever), why)


def _push(wheels: Sequence[JointFacts], wheel: float, speed: float) -> tuple[float, str]:
    efforts = [joint.effort for joint in wheels if joint.effort]
    share = [joint.inertia / wheel**2 for joint in wheels if joint.inertia]
    if len(efforts) == len(share) == len(wheels):
        push = _PART_OF_EFFORT * sum(efforts) / wheel / sum(share)
        if push < _GRIP:
            return push, "half of the wheels' effort limits, for the mass of the robot"
        return _GRIP, "the grip of the wheels"
    return min(speed / _IN, _GRIP), f"full speed in {_IN:g} s"


def _short(value: float) -> float:
    return float(f"{value:.3g}")
