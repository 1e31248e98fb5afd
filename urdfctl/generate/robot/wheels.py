"""Measure the wheels of a drive and determine their roles, from their positions with all joints at zero."""

from __future__ import annotations

import math
from collections.abc import Sequence

from urdfctl.generate.robot.facts import JointFacts
from urdfctl.generate.robot.name_words import SIDES, words_of
from urdfctl.model.geometry import Vector
from urdfctl.startup.records import NamedTuple

_ALONG = 0.9
"""The least component of an axis along a direction to count as parallel to it: cos 26 deg."""


class Measure(NamedTuple):
    """A number, None if it is unknown, and how it was determined."""

    value: float | None
    how: str


UNKNOWN = Measure(None, "unknown")


def radius(wheels: Sequence[JointFacts]) -> Measure:
    """Return the mean radius of the wheels, in m."""
    radii = [wheel.radius for wheel in wheels if wheel.radius]
    if not radii:
        return UNKNOWN
    how = "measured from the wheels"
    if max(radii) - min(radii) > 0.01 * max(radii):
        how = "measured; mean of wheels that differ"
    return Measure(_round(sum(radii) / len(radii)), how)


def across(left: Sequence[JointFacts], right: Sequence[JointFacts]) -> Measure:
    """Return the distance between the two sides, along the wheels' axes, in m."""
    ends = _middle(left), _middle(right)
    axis = left[0].axis if left else None
    if None in ends or axis is None:
        return UNKNOWN
    gap = _minus(ends[0] or _O, ends[1] or _O)
    distance = abs(sum(a * b for a, b in zip(gap, axis, strict=True))) or math.dist(_O, gap)
    return Measure(_round(distance), "measured between the joints") if distance > 0 else UNKNOWN


def along(driven: Sequence[JointFacts], steered: Sequence[JointFacts]) -> Measure:
    """Return the distance between the two axles, at right angles to the wheels' axes, in m."""
    ends = _middle(driven), _middle(steered)
    if None in ends or not driven or driven[0].axis is None:
        return UNKNOWN
    gap, axis = _minus(ends[0] or _O, ends[1] or _O), driven[0].axis
    sideways = sum(a * b for a, b in zip(gap, axis, strict=True))
    flat = math.hypot(gap[0] - sideways * axis[0], gap[1] - sideways * axis[1])
    return Measure(_round(flat), "measured between the joints") if flat > 0 else UNKNOWN


def from_centre(wheels: Sequence[JointFacts]) -> tuple[Measure, Measure]:
    """Return the wheels' mean distance from their centre, in m, and the angle of the first wheel, in rad."""
    middle = _middle(wheels)
    if middle is None:
        return UNKNOWN, UNKNOWN
    spokes = [_minus(wheel.at or _O, middle) for wheel in wheels]
    reach = sum(math.hypot(x, y) for x, y, _ in spokes) / len(spokes)
    angle = math.atan2(spokes[0][1], spokes[0][0])
    how = "measured between the joints"
    return (Measure(_round(reach), how) if reach > 0 else UNKNOWN), Measure(_round(angle), how)


def sides(joints: Sequence[JointFacts]) -> tuple[list[JointFacts], list[JointFacts]]:
    """Return the left and the right wheels of a robot that faces along x, each from front to rear.

    If no wheel is known to be on a side, the names of the joints say which ones are.
    """
    rolling = [joint for joint in joints if _rolls(joint)]
    ordered = sorted(rolling, key=lambda joint: -(joint.at or _O)[0])
    left = [joint for joint in ordered if (joint.at or _O)[1] > 0]
    right = [joint for joint in ordered if (joint.at or _O)[1] < 0]
    if left or right:
        return left, right
    turning = [joint for joint in joints if joint.type == "continuous" or joint.at is None]
    left, right = ([joint for joint in turning if _is_named(joint, side)] for side in ("left_", "right_"))
    return (left, right) if len(left) == len(right) else ([], [])


def _is_named(joint: JointFacts, side: str) -> bool:
    """Whether the name of a joint says that it is on a side, and not on the other one."""
    said = {SIDES[word] for word in words_of(joint.name) if word in SIDES}
    return bool(said) and all(one.endswith(side) for one in said)


def driven_and_steered(joints: Sequence[JointFacts]) -> tuple[list[JointFacts], list[JointFacts]]:
    """Return the driven wheels and the steering joints, which turn about the vertical, each from left to right."""
    steered = [joint for joint in joints if joint.axis and abs(joint.axis[2]) > _ALONG and not joint.slides]
    rolling = [joint for joint in joints if _rolls(joint)]
    middle = _middle(steered)
    if middle and len(rolling) > 2:  # noqa: PLR2004
        rolling = [joint for joint in rolling if math.dist((joint.at or _O)[:1], middle[:1]) > 0.05] or rolling  # noqa: PLR2004
    return _left_first(rolling), _left_first(steered)


def _left_first(joints: Sequence[JointFacts]) -> list[JointFacts]:
    return sorted(joints, key=lambda joint: (-(joint.at or _O)[1], -(joint.at or _O)[0]))


def _rolls(joint: JointFacts) -> bool:
    return joint.type == "continuous" and joint.axis is not None and abs(joint.axis[1]) > _ALONG


def _middle(joints: Sequence[JointFacts]) -> Vector | None:
    places = [place for joint in joints if (place := joint.middle or joint.at)]
    if not places or len(places) < len(joints):
        return None
    x, y, z = (sum(axis) / len(places) for axis in zip(*places, strict=True))
    return x, y, z


_O: Vector = (0.0, 0.0, 0.0)


def _minus(left: Vector, right: Vector) -> Vector:
    return left[0] - right[0], left[1] - right[1], left[2] - right[2]


def _round(value: float) -> float:
    return round(value, 5) + 0.0
