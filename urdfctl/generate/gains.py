"""Starting gains for tuning, computed from the load that a joint moves and the limits of its motor."""

from __future__ import annotations

import math

from urdfctl.generate.facts import JointFacts
from urdfctl.startup.records import NamedTuple

_HERTZ = 2.0
"""The bandwidth of the joint, slow enough to be stable at 100 Hz."""
_FULL_EFFORT_AT = 0.2
"""The error, in rad or m, at which the motor may reach its effort limit."""
_DIGITS = 3


class Gains(NamedTuple):
    """P, I and D, and how they were computed, in words."""

    p: float
    i: float
    d: float
    how: str


def starting_gains(joint: JointFacts, asked: str, commanded: str) -> Gains:
    """Return gains for a controller with a `position` or `velocity` as reference that commands `velocity` or `effort`.

    For an inertia J and effort commands, p = J w^2 and d = 2 J w (critical damping) for a position, and p = J w for a
    velocity, where w is 2 Hz. If J is unknown, p reaches the effort limit at an error of 0.2. The effort limit at that
    error is never exceeded.
    """
    listed = dict(joint.gains)
    if "p" in listed:
        return Gains(listed["p"], listed.get("i", 0.0), listed.get("d", 0.0), "from the joint list")
    if commanded == "velocity":
        return Gains(5.0 if asked == "position" else 1.0, 0.0, 0.0, f"{_START}: 1/s" if asked == "position" else _START)
    w, unit = 2 * math.pi * _HERTZ, "kg" if joint.slides else "kg m2"
    limit = joint.effort / _FULL_EFFORT_AT if joint.effort else None
    if joint.inertia is None:
        p = _short(limit or 100.0)
        how = f"{_START}, from the effort limit" if limit else f"{_START}; TODO: inertia and effort limit are unknown"
        return Gains(p, 0.0, _short(p / w * 2) if asked == "position" else 0.0, how)
    if asked == "velocity":
        return Gains(_short(joint.inertia * w), 0.0, 0.0, f"{_START}, from the load of {joint.inertia:.3g} {unit}")
    stiff = joint.inertia * w * w
    p = min(stiff, limit) if limit else stiff
    damping = 2 * math.sqrt(p * joint.inertia)
    source = "effort limit" if limit and limit < stiff else f"load of {joint.inertia:.3g} {unit}"
    return Gains(_short(p), 0.0, _short(damping), f"{_START}, from the {source}")


_START = "starting values, to be tuned"


def _short(value: float) -> float:
    """A number rounded to three significant digits."""
    return float(f"{value:.{_DIGITS}g}") or 1e-6
