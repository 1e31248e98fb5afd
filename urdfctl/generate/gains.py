"""Gains to start tuning with: from what a joint moves and what its motor can do, never meant to be the last word."""

from __future__ import annotations

import math

from urdfctl.generate.facts import JointFacts
from urdfctl.record import NamedTuple

_HERTZ = 2.0
"""How fast the joint shall answer: slow enough to be stable at 100 Hz."""
_FULL_EFFORT_AT = 0.2
"""The error, in rad or m, at which a motor may give all it has."""
_DIGITS = 3


class Gains(NamedTuple):
    """P, I and D, and how they were found, in words."""

    p: float
    i: float
    d: float
    how: str


def starting_gains(joint: JointFacts, asked: str, commanded: str) -> Gains:
    """Gains of a controller that is asked for a `position` or a `velocity` and commands a `velocity` or an `effort`.

    An effort moves an inertia J with p = J w^2, d = 2 J w (critical damping), or p = J w from a speed; w is 2 Hz. Where
    J is not known, the effort limit at an error of 0.2 is taken. The effort limit at that error is never exceeded.
    """
    told = dict(joint.gains)
    if "p" in told:
        return Gains(told["p"], told.get("i", 0.0), told.get("d", 0.0), "as the list of joints says")
    if commanded == "velocity":
        return Gains(5.0 if asked == "position" else 1.0, 0.0, 0.0, f"{_START}: 1/s" if asked == "position" else _START)
    w, unit = 2 * math.pi * _HERTZ, "kg" if joint.slides else "kg m2"
    limit = joint.effort / _FULL_EFFORT_AT if joint.effort else None
    if joint.inertia is None:
        p = _short(limit or 100.0)
        how = f"{_START}, by the effort limit alone" if limit else f"{_START}; TODO: nothing is known of the joint"
        return Gains(p, 0.0, _short(p / w * 2) if asked == "position" else 0.0, how)
    if asked == "velocity":
        return Gains(_short(joint.inertia * w), 0.0, 0.0, f"{_START}, by the {joint.inertia:.3g} {unit} that it moves")
    stiff = joint.inertia * w * w
    p = min(stiff, limit) if limit else stiff
    damping = 2 * math.sqrt(p * joint.inertia)
    by = "effort limit" if limit and limit < stiff else f"{joint.inertia:.3g} {unit} that it moves"
    return Gains(_short(p), 0.0, _short(damping), f"{_START}, by the {by}")


_START = "starting values, to be tuned"


def _short(value: float) -> float:
    """A number with three digits that mean something."""
    return float(f"{value:.{_DIGITS}g}") or 1e-6
