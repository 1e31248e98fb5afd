"""The pose of a robot at which one of its controllers failed, for the page of a run."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from typing import Any

from urdfctl.page.chart import replay_of
from urdfctl.smoke.results import Curve


def failing_pose(controller: str, curves: Sequence[Curve]) -> dict[str, Any] | None:
    """Return where the joints of a controller were when one of them was farthest from where it should be.

    None if nothing shows that. The joint, the time in s, and the positions in rad or m by joint.
    """
    own = [curve for curve in curves if curve.controller == controller and replay_of(curve)]
    amiss = ((part, second, curve.joint) for curve in own for part, second in _amiss(curve))
    worst = max(amiss, default=(0.0, 0.0, ""))
    if not worst[0]:
        return None
    _, second, joint = worst
    replays = {one["joint"]: one for curve in own if (one := replay_of(curve))}
    return {
        "joint": joint,
        "second": round(second, 2),
        "positions": {name: _at(one["seconds"], one["positions"], second) for name, one in replays.items()},
    }


def _amiss(curve: Curve) -> Iterator[tuple[float, float]]:
    """How far a joint is from where it should be, as a part of its motion, at each time that counts.

    A joint that only has to end somewhere counts at its end, and where it is beyond its limits.
    """
    low, high = curve.limits or (-math.inf, math.inf)
    size = max((abs(value) for value in (*curve.commanded, *curve.measured)), default=0.0) or 1.0
    for second, value in zip(curve.seconds, curve.measured, strict=False):
        yield max(0.0, low - value, value - high) / size, second
    if curve.band is not None and curve.measured:
        last = curve.measured[-1]
        yield max(0.0, curve.band[0] - last, last - curve.band[1]) / size, curve.seconds[-1]
    elif curve.band is None:
        for second, wanted, value in zip(curve.seconds, curve.commanded, curve.measured, strict=False):
            yield abs(value - wanted) / size, second


def _at(seconds: Sequence[float], values: Sequence[float], second: float) -> float:
    return values[min(bisect_left(seconds, second), len(values) - 1)]
