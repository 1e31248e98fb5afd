"""Robots that nothing fixes to the world: what they would rest on, if they were put down on flat ground."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from urdfctl.model.geometry import minus, turned
from urdfctl.smoke.robot import TIPPED, Mechanism, RestPose, Shapes, rest_pose_of, sampled_poses
from urdfctl.startup.records import NamedTuple

LEAST_FEET = 2
_LEAST_AREA = 1e-6
"""Contacts that span less than this, in m², support no robot: it balances."""


class Support(NamedTuple):
    """The links on which a robot rests with its joints held at spawn.

    links: the feet of its legs, or parts of its base; none if it does not stand, or if that is not known.
    why_not: the reason if there are none.
    tips: when a base on which a robot lies tips over, or empty.
    """

    links: tuple[str, ...] = ()
    why_not: str = ""
    tips: str = ""


def support_of(mechanism: Mechanism, shapes: Shapes, moved: Collection[str]) -> Support:
    """Return what a robot rests on, whose controllers move some joints."""
    at_rest = rest_pose_of(mechanism, shapes) if shapes.complete else None
    feet = _feet(mechanism, at_rest) if at_rest else ()
    unknown = "" if feet else _why_unknown(mechanism, shapes)
    if not at_rest or feet or unknown:
        return Support(feet, unknown)
    if at_rest.tilt > TIPPED:
        return Support((), _held("at spawn"), "at spawn")
    carrying = {name: points for name, points in at_rest.contacts.items() if _is_still(mechanism, name, moved)}
    hull = _hull([(x, y) for points in carrying.values() for x, y, _ in points])
    if not mechanism.body_of(mechanism.root) & set(carrying):
        return Support(why_not="it rests on links that its controllers move")
    if _area(hull) < _LEAST_AREA:
        return Support(why_not="it balances on a point or a line of its base")
    tips = _tipping(mechanism, at_rest, hull)
    return Support(tuple(carrying), _held(tips), tips) if tips else Support(tuple(carrying))


def _why_unknown(mechanism: Mechanism, shapes: Shapes) -> str:
    """Why nothing can be said of a robot on the ground, or an empty text."""
    base = mechanism.body_of(mechanism.root)
    if not shapes.complete:
        return f"the collision geometry of link '{min(shapes.unknown)}' is unknown"
    if not any(shapes.known.get(name) for name in base):
        return "its base has no collision geometry"
    return "" if any(mechanism.bodies[name].mass > 0 for name in base) else "its base has no mass"


def _held(when: str) -> str:
    return f"it tips over {when} unless its base is fixed; if it is, add a link 'world'"


def _feet(mechanism: Mechanism, at_rest: RestPose) -> tuple[str, ...]:
    """The feet of a legged robot: each is at the end of a leg of its own, whose joints have limits."""
    if at_rest.tilt > TIPPED:
        return ()
    legs = {name: [hinge for hinge in mechanism.above(name) if hinge.moves] for name in at_rest.contacts}
    if not all(legs.values()) or any(hinge.type == "continuous" for leg in legs.values() for hinge in leg):
        return ()
    return tuple(legs) if len({leg[-1].name for leg in legs.values()}) >= LEAST_FEET else ()


def _is_still(mechanism: Mechanism, link: str, moved: Collection[str]) -> bool:
    """Whether no controller moves a link: it is a part of the base, or rolls freely."""
    return all(
        not hinge.moves or (hinge.type == "continuous" and hinge.name not in moved) for hinge in mechanism.above(link)
    )


# -- the centre of mass over the base --------------------------------------------------------------------------------


def _tipping(mechanism: Mechanism, at_rest: RestPose, hull: Sequence[tuple[float, float]]) -> str:
    """When the centre of mass is not over the base: at spawn, or in the first of many poses; empty if never."""
    start = mechanism.start()
    origin = mechanism.centre_of_mass(mechanism.poses(start))
    for pose in (start, *sampled_poses(mechanism)):
        x, y, _ = turned(at_rest.turn, minus(mechanism.centre_of_mass(mechanism.poses(pose)), origin))
        if not _inside(hull, (x, y)):
            shown = [f"{name} at {place:.2g}" for name, place in pose.items() if abs(place - start[name]) > 0.01]  # noqa: PLR2004
            more = f" and {len(shown) - 3} more" if len(shown) > 3 else ""  # noqa: PLR2004
            return f"with {', '.join(shown[:3])}{more}" if shown else "at spawn"
    return ""


def _hull(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """The corners of the convex hull, to the left around (Andrew's monotone chain)."""
    hull: list[tuple[float, float]] = []
    ordered = sorted(set(points))
    for way in (ordered, ordered[::-1]):
        chain: list[tuple[float, float]] = []
        for point in way:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        hull += chain[:-1]
    return hull


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    """Twice the area of a triangle, positive if it goes around to the left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _area(hull: Sequence[tuple[float, float]]) -> float:
    return math.fsum(_turn((0.0, 0.0), a, b) for a, b in zip(hull, (*hull[1:], *hull[:1]), strict=True)) / 2


def _inside(hull: Sequence[tuple[float, float]], point: tuple[float, float]) -> bool:
    return all(_turn(a, b, point) >= 0 for a, b in zip(hull, (*hull[1:], *hull[:1]), strict=True))
