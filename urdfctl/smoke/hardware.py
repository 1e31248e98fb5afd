"""The ranges of commands that the hardware allows between a controller and its joints."""

from __future__ import annotations

import math

from urdfctl.smoke.mechanism import Hinge, Mechanism


def within_ranges(mechanism: Mechanism) -> Mechanism:
    """Return a mechanism whose limits of velocity and effort are those that `<ros2_control>` allows to command."""
    return mechanism._replace(hinges=tuple(map(_limited, mechanism.hinges)))


def _limited(hinge: Hinge) -> Hinge:
    velocity, effort = (
        _least(own, _greatest(hinge, name)) for own, name in ((hinge.velocity, "velocity"), (hinge.effort, "effort"))
    )
    return hinge._replace(velocity=velocity, effort=effort)


def _greatest(hinge: Hinge, interface: str) -> float:
    """The greatest command to an interface in either direction; infinite if there is no range."""
    return max(map(abs, hinge.range_of(interface)))


def _least(limit: float | None, most: float) -> float | None:
    """A limit that is not greater than the greatest command; a limit of 0 means something else and is kept."""
    if not math.isfinite(most) or most <= 0 or limit == 0:
        return limit
    return most if limit is None else min(limit, most)
