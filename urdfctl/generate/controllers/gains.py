"""Starting gains for tuning, computed from the load that a joint moves and the limits of its motor."""

from __future__ import annotations

import math

from urdfctl.generate.robot.facts import JointFacts, Load
from urdfctl.startup.records import NamedTuple

_HERTZ = 2.0
"""The bandwidth of the joint, slow enough to be stable at 100 Hz."""
_FULL_EFFORT_AT = 0.2
"""The error, in rad or m, at which the motor may reach its effort limit."""
_SAG, _LEAST_SAG = 0.03, 0.002
"""The error, in rad or m, that the weight may cause before the integral part acts; below the second one is none."""
_STIFFEST = 0.05
"""The error, in rad or m, at which the motor may reach its effort limit where its weight requires a greater P."""
_DAMPING, _LEAST_DAMPING = 1.0, 0.35
"""The damping ratio of the loop, and the least one if the update rate limits the damping."""
_PER_UPDATE = 0.5
"""The part of its velocity that damping may take from the lightest load in one update, for all joints together."""
_GRIP_AT, _GRIP_PART = 0.1, 0.25
"""The error, in rad or as a part of the range of a prismatic joint, at which fingers grip with the effort limit."""
_LAG = 0.1
"""The time, in s, by which the joint's own damping may delay it."""
_INTEGRAL = 1.0
"""I as a fraction of P, in 1/s: slower than the loop."""
_MARGIN = 1.25
"""The integral part may hold the weight of the worst sampled pose times this."""
_DIGITS = 3


class Loop(NamedTuple):
    """The loop that a joint is in: `period` of the updates in s, and the number of `joints` in it.

    `grips`: it closes fingers, which never reach the position that they are sent to.
    """

    period: float = 0.01
    joints: int = 1
    grips: bool = False


class Gains(NamedTuple):
    """P, I and D, the limit of the integral part, and how they were computed, in words."""

    p: float
    i: float
    d: float
    how: str
    i_clamp: float | None = None


def starting_gains(joint: JointFacts, asked: str, commanded: str, loop: Loop | None = None) -> Gains:
    """Return gains for a controller with a `position` or `velocity` as reference that commands `velocity` or `effort`.

    For an inertia J and effort commands, p = J w^2 for a position, and p = J w for a velocity, where w is 2 Hz. p is
    greater if the weight in the worst pose would bend the joint by more than 0.03, and then the integral part holds
    the weight. The effort limit at an error of 0.05 is never exceeded, except by fingers, which reach it at a quarter
    of their range, so that they grip. d damps the heaviest load, as far as the lightest one stays stable at the update
    rate. If J is unknown, p reaches the effort limit at an error of 0.2.
    """
    listed = dict(joint.gains)
    if "p" in listed:
        clamp = listed.get("i_clamp")
        return Gains(listed["p"], listed.get("i", 0.0), listed.get("d", 0.0), "from the joint list", clamp)
    if commanded == "velocity":
        return Gains(5.0 if asked == "position" else 1.0, 0.0, 0.0, f"{_START}: 1/s" if asked == "position" else _START)
    w, unit = 2 * math.pi * _HERTZ, "kg" if joint.slides else "kg m2"
    if joint.inertia is None:
        limit = joint.effort / _FULL_EFFORT_AT if joint.effort else None
        p = _short(limit or 100.0)
        how = f"{_START}, from the effort limit" if limit else f"{_START}; TODO: inertia and effort limit are unknown"
        return Gains(p, 0.0, _short(p / w * 2) if asked == "position" else 0.0, how)
    load = joint.load or Load(0.0, joint.inertia, joint.inertia)
    if asked == "velocity":
        p = min(joint.inertia * w, _most_damping(load, loop or Loop()))
        return Gains(_short(p), 0.0, 0.0, f"{_START}, from the load of {joint.inertia:.3g} {unit}")
    return _of_position(joint, load, loop or Loop(), f"{load.heaviest:.3g} {unit}")


def _most_damping(load: Load, loop: Loop) -> float:
    return _PER_UPDATE * load.lightest / (min(loop.joints, load.coupling) * loop.period)


def _of_position(joint: JointFacts, load: Load, loop: Loop, mass: str) -> Gains:
    w, unit = 2 * math.pi * _HERTZ, "N" if joint.slides else "N m"
    held = load.gravity + joint.friction
    wanted = {
        f"load of {mass}": load.heaviest * w * w,
        f"weight of {load.gravity:.3g} {unit}": held / _SAG,
        "damping of the joint": joint.damping / _LAG,
    }
    if loop.grips and joint.effort:
        wanted["grip at the effort limit"] = joint.effort / _grip_error(joint)
    how, p = max(wanted.items(), key=lambda item: item[1])
    limit = joint.effort / (_STIFFEST if held or joint.damping else _FULL_EFFORT_AT) if joint.effort else None
    if limit and p > limit and not loop.grips:
        p, how = limit, "effort limit"
    d = max(0.0, 2 * _DAMPING * math.sqrt(p * load.heaviest) - joint.damping)
    most = _most_damping(load, loop)
    if d > most:
        d = most
        softest = ((d + joint.damping) / (2 * _LEAST_DAMPING)) ** 2 / load.heaviest
        if p > softest:
            p, how = softest, f"update rate of {1 / loop.period:g} Hz"
    holds = held / p > _LEAST_SAG
    clamp = min(held * _MARGIN, joint.effort or math.inf)
    note = f"; the weight of {load.gravity:.3g} exceeds the effort limit" if _too_weak(joint, load) else ""
    return Gains(
        p=_short(p),
        i=_short(_INTEGRAL * p) if holds else 0.0,
        d=_short(d) if d else 0.0,
        how=f"{_START}, from the {how}{note}",
        i_clamp=_short(clamp) if holds else None,
    )


def _grip_error(joint: JointFacts) -> float:
    if not joint.slides:
        return _GRIP_AT
    known = joint.lower is not None and joint.upper is not None and joint.lower < joint.upper
    return _GRIP_PART * ((joint.upper or 0.0) - (joint.lower or 0.0) if known else _GRIP_AT)


def _too_weak(joint: JointFacts, load: Load) -> bool:
    return bool(joint.effort) and load.gravity > (joint.effort or 0.0)


_START = "starting values, to be tuned"


def _short(value: float) -> float:
    """A number rounded to three significant digits."""
    return float(f"{value:.{_DIGITS}g}") or 1e-6
