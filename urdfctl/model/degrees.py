"""Angles that are most likely in degrees, where the format has radians: limits of joints, and rotations."""

from __future__ import annotations

import math
from collections.abc import Iterable

MOST_TURN = 4 * math.pi
"""No joint with limits turns farther than this to one side, in rad, but a winch or a wheel."""
MOST_DEGREES = 720.0
"""A limit beyond this, in rad, stands for no limit."""
NEAR_FRACTION = 0.005
"""A rotation that is as near as this to an eighth of a half turn, in rad, is one in radians."""


def are_limits_in_degrees(kind: str | None, limits: Iterable[float]) -> bool:
    """Return whether the limits of a joint are most likely in degrees: beyond two turns, and halves as people give.

    kind: the type of the joint.
    """
    given = list(limits)
    most = max(map(abs, given), default=0.0)
    return kind == "revolute" and MOST_TURN < most <= MOST_DEGREES and all(map(_is_even, given))


def limit_meant(given: float) -> float:
    """Return a limit in rad of a joint with limits in degrees; a small one may be in rad already."""
    return math.radians(given) if abs(given) > math.pi / 2 else given


def is_rotation_in_degrees(angles: Iterable[float]) -> bool:
    """Return whether the angles of a rotation are most likely in degrees: more than a turn, and no part of one."""
    return any(map(_in_degrees, angles))


def written_in_radians(text: str, *, in_xacro: bool) -> str:
    """Return what to write for a number in degrees: a conversion in xacro, so that the number stays; in URDF, the angle
    in rad."""
    return f"${{radians({text})}}" if in_xacro else f"{math.radians(float(text)):.6g}"


def limits_in_words(joint: str, lower: float, upper: float) -> str:
    """Return the message on the limits of a joint, with those that are meant."""
    turns = max(abs(lower), abs(upper)) / 2 / math.pi
    return (
        f"joint '{joint}' has limits of {lower:g} to {upper:g} rad, up to {turns:.2g} turns: most likely degrees; "
        f"in rad they are {limit_meant(lower):.4g} to {limit_meant(upper):.4g}"
    )


def rotation_in_words(part: str, angles: Iterable[float]) -> str:
    """Return the message on the rotation of a part, with the one that is meant."""
    given = list(angles)
    shown = " ".join(f"{angle:g}" for angle in given)
    meant = " ".join(f"{math.radians(angle):.4g}" for angle in given)
    return f"{part} is turned by rpy {shown} rad, more than a turn: most likely degrees; in rad it is {meant}"


def _is_even(limit: float) -> bool:
    """Whether a limit is a number that people give in degrees: in halves."""
    return math.isfinite(limit) and (2 * limit).is_integer()


def _in_degrees(angle: float) -> bool:
    eighth = math.pi / 8
    by_eighths = abs(angle - eighth * round(angle / eighth)) < NEAR_FRACTION if math.isfinite(angle) else True
    return 2 * math.pi < abs(angle) <= MOST_DEGREES and not by_eighths
