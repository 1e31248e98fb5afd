"""Limits that are written, but leave no range or are not read: soft limits, and those of continuous joints."""

from __future__ import annotations

import math
from collections.abc import Iterator

from urdfctl.model.robot import Joint, Number, Robot, leading_number
from urdfctl.rules.smoke.continuous_with_limits import continuous_with_limits
from urdfctl.rules.smoke.soft_limits_without_range import soft_limits_without_range
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism

LESS_THAN_A_TURN = 1.95 * math.pi
"""A joint with limits this far apart or farther is meant to turn all around."""
FAR = 0.2
"""A joint may start outside of its soft limits by this part of its range: many start at a mechanical end."""


def written_limit_troubles(mechanism: Mechanism, robot: Robot) -> Iterator[Trouble]:
    """Yield the joints whose soft limits leave no range, and continuous joints with limits of less than a turn."""
    for joint in robot.joints:
        hinge = mechanism.hinge(joint.name or "")
        if hinge is None or not hinge.moves:
            continue
        yield from _soft(joint, hinge)
        lower, upper = (leading_number(number.text) if number else None for number in _given(joint))
        if hinge.type != "continuous" or lower is None or upper is None:
            continue
        if 0 < upper - lower < LESS_THAN_A_TURN and lower <= 0 <= upper:
            fields = {"joint": hinge.name, "lower": lower, "upper": upper}
            yield trouble_of(continuous_with_limits, f"joint:{hinge.name}", None, (), **fields)


def _given(joint: Joint) -> tuple[Number | None, Number | None]:
    return (joint.limit.lower, joint.limit.upper) if joint.limit else (None, None)


def _soft(joint: Joint, hinge: Hinge) -> Iterator[Trouble]:
    safety = next(joint.tag.named("safety_controller"), None)
    if safety is None or hinge.type == "continuous":
        return
    given = [safety.attributes.get(f"soft_{end}_limit") for end in ("lower", "upper")]
    lower, upper = (leading_number(text) if text else 0.0 for text in given)
    if given == [None, None] or lower is None or upper is None:
        return
    low, high = hinge.span
    fields = {"joint": hinge.name, "lower": lower, "upper": upper, "unit": hinge.unit}
    why = ""
    if lower >= upper and not lower == upper == 0:
        why = "which leave no range" + ("; they are exchanged" if lower > upper else "")
    elif upper <= low or lower >= high:
        why = f"outside of its limits of {low:g} to {high:g} {hinge.unit}"
    elif lower < upper and max(lower - hinge.start, hinge.start - upper) > FAR * (high - low):
        why = f"but it starts at {hinge.start:g} {hinge.unit}"
    if why:
        yield trouble_of(soft_limits_without_range, f"joint:{hinge.name}", None, (), **fields, why=why)
