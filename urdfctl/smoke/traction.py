"""Whether the wheels of a base grip the ground well enough to drive it, by formula."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.geometry import Vector
from urdfctl.rules.smoke.wheels_slip import wheels_slip
from urdfctl.smoke.engines import friction_of
from urdfctl.smoke.loads import GRAVITY, TIME
from urdfctl.smoke.mechanism import Mechanism
from urdfctl.smoke.motions import speed_of
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.tasks import Task

_LITTLE = 1e-9
"""What is added to the spread of contacts along each axis, in m²."""


def shares_of(places: Sequence[Vector]) -> list[float]:
    """Return the share of the weight that each contact carries, given their places from the centre of mass, in m.

    They add up to 1, and their moments cancel. Of more than three contacts the shares are a linear function of the
    place, as on equal springs under a stiff robot; a contact that would have to pull carries nothing.
    """
    carrying = list(range(len(places)))
    while carrying:
        shares = _balanced([places[n] for n in carrying])
        if min(shares) >= 0:
            return [shares[carrying.index(n)] if n in carrying else 0.0 for n in range(len(places))]
        carrying.pop(min(range(len(shares)), key=shares.__getitem__))
    return []


def _balanced(places: Sequence[Vector]) -> list[float]:
    """Shares a + b x + c y whose sum is 1 and whose moments are 0; contacts on a line or in a point balance what they
    can."""
    n = len(places)
    x0, y0 = (sum(place[axis] for place in places) / n for axis in range(2))
    offsets = [(place[0] - x0, place[1] - y0) for place in places]
    xx, xy, yy = (sum(a[i] * a[j] for a in offsets) for i, j in ((0, 0), (0, 1), (1, 1)))
    xx, yy = xx + _LITTLE, yy + _LITTLE
    determinant = xx * yy - xy * xy
    b, c = (xy * y0 - yy * x0) / determinant, (xy * x0 - xx * y0) / determinant
    return [1 / n + b * x + c * y for x, y in offsets]


def traction_troubles(
    mechanism: Mechanism, contacts: Mapping[str, Sequence[Vector]], tasks: Sequence[Task]
) -> Iterator[Trouble]:
    """Yield the bases whose wheels slip: they cannot drag what slides, and accelerate the robot, without it.

    `contacts` holds the points in which links touch the ground, from the centre of mass, in m.
    """
    places = [_middle(points) for points in contacts.values()]
    weight = -GRAVITY[2] * sum(body.mass for body in mechanism.bodies.values())
    loads = {name: share * weight for name, share in zip(contacts, shares_of(places), strict=True)}
    for task in tasks:
        drive = task.drive
        hinges = [hinge for name in drive.wheels if (hinge := mechanism.hinge(name))] if drive else []
        if not drive or not hinges:
            continue
        wheels = {hinge.child for hinge in hinges}
        thrust = sum(_friction(mechanism, name, load) for name, load in loads.items() if name in wheels)
        drags = {
            name: _friction(mechanism, name, loads[name], slides=True) for name in loads if _drags(mechanism, name)
        }
        needed = weight / -GRAVITY[2] * speed_of(drive, hinges) / TIME
        if thrust >= sum(drags.values()) + needed:
            continue
        fields = {"thrust": f"{thrust:.2g}", "needed": f"{sum(drags.values()) + needed:.2g}"}
        notes = [f"link '{name}' is dragged with {drag:.2g} N" for name, drag in drags.items() if drag > needed]
        low = [name for name in wheels if (grip := mechanism.bodies[name].grip) is not None and grip < 1]
        notes += [f"<gazebo> gives link '{name}' the friction {mechanism.bodies[name].grip:g}" for name in sorted(low)]
        yield trouble_of(wheels_slip, f"controller:{task.controller}", task.controller, tuple(notes), **fields)


def _middle(points: Sequence[Vector]) -> Vector:
    x, y, z = (sum(values) / len(points) for values in zip(*points, strict=True))
    return x, y, z


def _friction(mechanism: Mechanism, name: str, load: float, *, slides: bool = False) -> float:
    """The greatest force of a contact along the ground, in N."""
    return load * friction_of(mechanism.bodies[name].grip, is_wheel=not slides)


def _drags(mechanism: Mechanism, name: str) -> bool:
    """Whether a link slides on the ground when the robot drives: no joint without limits lets it roll."""
    return not any(hinge.type == "continuous" for hinge in mechanism.above(name))
