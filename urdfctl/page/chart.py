"""A curve as a chart: where its lines, ticks and bands are on the drawing, for the template."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import Any

from urdfctl.smoke.results import Curve
from urdfctl.startup.records import NamedTuple

WIDTH, HEIGHT = 360, 190
_LEFT, _RIGHT, _TOP, _BOTTOM = 52, 350, 10, 120
_EFFORT_TOP, _EFFORT_BOTTOM = 140, 170
_QUANTITIES = {"ahead": "distance forward", "distance": "distance from the start", "yaw": "turn to the left"}
_MARGIN = 0.08
"""The lines stay away from the frame by this fraction of its height."""


class _Scale(NamedTuple):
    """A range of values, and the range of the drawing that shows it."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        """Return where a value is on the drawing."""
        return self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)


def chart(curve: Curve) -> dict[str, Any]:
    """Return what the template draws of a curve."""
    quantity = _QUANTITIES.get(curve.quantity, curve.quantity)
    most = curve.seconds[-1] if curve.seconds and curve.seconds[-1] > 0 else 1.0
    along, up = _Scale(0.0, most, _LEFT, _RIGHT), _vertical(curve)
    title = f"{curve.joint}: {quantity}" if curve.joint != "base" else quantity
    return {
        "controller": curve.controller,
        "joint": curve.joint,
        "title": title,
        "label": _label(curve, title),
        "unit": curve.unit,
        "x_ticks": [(along.at(value), f"{value:g}") for value in _ticks(0.0, most, 4)],
        "y_ticks": [(up.at(value), f"{value:.6g}") for value in _ticks(up.low, up.high, 4)],
        "commanded": _line(curve.seconds, curve.commanded, along, up),
        "measured": _line(curve.seconds, curve.measured, along, up),
        "band": _band(curve, up),
        "limits": [up.at(value) for value in curve.limits or () if up.low <= value <= up.high],
        "effort": _effort(curve, along),
        "facts": _facts(curve),
        "replay": replay_of(curve),
    }


def _vertical(curve: Curve) -> _Scale:
    values = [value for value in (*curve.commanded, *curve.measured, *(curve.band or ())) if math.isfinite(value)]
    low, high = min(values, default=0.0), max(values, default=1.0)
    span = high - low or abs(high) or 1.0
    # limits are shown if they are near: far ones would flatten the curve
    near = [value for value in curve.limits or () if low - span / 2 <= value <= high + span / 2]
    low, high = min([low, *near]), max([high, *near])
    edge = _MARGIN * (high - low or span)
    return _Scale(low - edge, high + edge, _BOTTOM, _TOP)


def _ticks(low: float, high: float, wanted: int) -> list[float]:
    """Round values between two others, about as many as wanted."""
    raw = (high - low) / wanted
    power = 10.0 ** math.floor(math.log10(raw)) if raw > 0 else 1.0
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= raw * 0.999)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [round(n * step, 12) for n in range(first, last + 1)]


def _line(seconds: Sequence[float], values: Sequence[float], along: _Scale, up: _Scale) -> str:
    pairs = [(x, y) for x, y in zip(seconds, values, strict=False) if math.isfinite(y)]
    return " ".join(f"{along.at(x):.1f},{up.at(y):.1f}" for x, y in pairs)


def _band(curve: Curve, up: _Scale) -> dict[str, float] | None:
    if curve.band is None:
        return None
    low, high = (up.at(value) for value in curve.band)
    return {"y": high, "height": low - high, "x": _LEFT, "width": _RIGHT - _LEFT}


def _effort(curve: Curve, along: _Scale) -> dict[str, Any] | None:
    """The line of the effort, from 0 to 100 per cent of its limit, in either direction."""
    if not curve.efforts:
        return None
    up = _Scale(0.0, 100.0, _EFFORT_BOTTOM, _EFFORT_TOP)
    values = [min(abs(value), 100.0) for value in curve.efforts]
    return {"line": _line(curve.seconds, values, along, up), "low": _EFFORT_BOTTOM, "high": _EFFORT_TOP}


def _facts(curve: Curve) -> str:
    found = []
    if curve.band is not None:
        found.append(f"must end between {curve.band[0]:.4g} and {curve.band[1]:.4g} {curve.unit}")
    if curve.limits is not None:
        found.append(f"limits {curve.limits[0]:.4g} to {curve.limits[1]:.4g} {curve.unit}")
    if curve.efforts:
        found.append(f"effort up to {max(map(abs, curve.efforts)):.0f} % of its limit")
    return "; ".join(found)


def _label(curve: Curve, title: str) -> str:
    ends = [f"{name} ends at {values[-1]:.4g} {curve.unit}" for name, values in _lines(curve) if values]
    return ", ".join([f"{title} in {curve.unit} over {curve.seconds[-1] if curve.seconds else 0:.2g} s", *ends])


def _lines(curve: Curve) -> tuple[tuple[str, Sequence[float]], ...]:
    return ("commanded", curve.commanded), ("measured", curve.measured)


def replay_of(curve: Curve) -> dict[str, Any] | None:
    """Return the positions of a joint over time; of a velocity its sum. None for the motion of a base."""
    if curve.quantity == "position":
        return {"joint": curve.joint, "seconds": curve.seconds, "positions": curve.measured}
    if curve.quantity != "velocity" or not curve.seconds:
        return None
    periods = [curve.seconds[0], *(later - sooner for sooner, later in pairwise(curve.seconds))]
    positions = accumulate(speed * period for speed, period in zip(curve.measured, periods, strict=True))
    return {"joint": curve.joint, "seconds": curve.seconds, "positions": [round(place, 5) for place in positions]}
