"""The gain that makes a control loop unstable, with the range in which it would be stable."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.smoke.robot import Hinge
from urdfctl.smoke.tasks import PidGains
from urdfctl.startup.records import NamedTuple

_HALVINGS = 24
_LEAST = 1e-6
"""Gains are lowered to this part at most, and raised to its reciprocal."""
NAMES = ("d", "p", "i")


class GainFault(NamedTuple):
    """A gain that is wrong, and why, in words that begin with the gain."""

    gain: str
    why: str


def gain_fault(
    hinge: Hinge, gains: PidGains, inertia: float | None, rate: float, is_stable: Callable[[PidGains], bool]
) -> GainFault | None:
    """Return the gain of a joint that makes its own loop unstable; None if the loop is stable by itself.

    inertia: what the joint moves, in kg m² or kg; None if the hardware follows velocities whatever it is.
    rate: the update rate, in Hz.
    is_stable: whether the joint alone is stable with some gains.
    """
    for name in ("p", "i", "d"):
        value = getattr(gains, name)
        if value < 0:
            return GainFault(name, f"{name} of joint '{hinge.name}' is {value:g}, which pushes it away from its target")
    if is_stable(gains):
        return None
    if not gains.p:
        return GainFault("p", f"p of joint '{hinge.name}' is 0, so that nothing holds it")
    ranges = {name: _greatest(gains, name, is_stable) for name in NAMES if getattr(gains, name) > 0}
    found = {name: most for name, most in ranges.items() if most is not None}
    name = max(found, key=lambda each: found[each] / getattr(gains, each), default="")
    steadying = None if name == "d" else _least_damping(gains, is_stable)
    unit = "kg" if hinge.type == "prismatic" else "kg m²"
    where = (f"with the {inertia:.2g} {unit} that it moves, " if inertia else "") + f"at {rate:g} Hz"
    if name:
        too_high = f"{name} of joint '{hinge.name}' is {getattr(gains, name):g}, but is stable only up to"
        instead = f", or with a d of {steadying:g}" if steadying else ""
        return GainFault(name, f"{too_high} {found[name]:.2g} {where}{instead}")
    if steadying:
        return GainFault(
            "d", f"d of joint '{hinge.name}' is {gains.d:g}, which is too low: {steadying:g} steadies it {where}"
        )
    return None


def _least_damping(gains: PidGains, is_stable: Callable[[PidGains], bool]) -> float | None:
    """A rounded d above the given one with which the loop is stable, about the least or twice it; None if none is."""
    d = max(gains.d, _LEAST * gains.p)
    while d <= gains.p:
        d *= 2
        rounded = float(f"{d:.2g}")
        if is_stable(gains._replace(d=rounded)):
            return rounded
    return None


def _greatest(gains: PidGains, name: str, is_stable: Callable[[PidGains], bool]) -> float | None:
    """The greatest value below the given one with which the loop is stable; None if lower ones do not help."""
    value, low = getattr(gains, name), _LEAST
    with_gain = {
        "p": lambda v: gains._replace(p=v),
        "i": lambda v: gains._replace(i=v),
        "d": lambda v: gains._replace(d=v),
    }
    while low < 1 and not is_stable(with_gain[name](low * value)):
        low *= 4
    if low >= 1:
        return None
    high = 1.0
    for _ in range(_HALVINGS):
        middle = (low * high) ** 0.5
        low, high = (middle, high) if is_stable(with_gain[name](middle * value)) else (low, middle)
    return float(low * value)
