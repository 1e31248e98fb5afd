"""Links of a robot that overlap at spawn, or with all joints at 0."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping

from urdfctl.model.geometry import Pose, Vector, dot, minus, plus, scaled, transposed, turned
from urdfctl.rules.smoke.links_overlap import links_overlap
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Mechanism, Shape, Shapes

SHRUNK = 0.9
"""Shapes are shrunk to this part of their size around their middle: links that touch do not overlap."""
MOST_LINKS = 100
"""Robots with more links that have simple shapes are not checked: the pairs would take seconds."""
_STEPS = 100
"""After so many steps without a separating plane or a common point, two shapes count as apart."""
_NEAR = 0.05
"""Shapes overlap if the algorithm comes as near as this to a common point, as a fraction of the smallest dimension.
Shapes that touch are twice as far apart when they are shrunk."""

Pair = frozenset[str]


def overlap_troubles(mechanism: Mechanism, shapes: Shapes, allowed: Collection[Pair] = ()) -> Iterator[Trouble]:
    """Yield the links that overlap at spawn, and those that overlap with all joints at 0, unless a pair is allowed.

    Neighbours may overlap, also over one link between them, as in wrists. Meshes are not looked at: only their convex
    hulls are known.
    """
    start = mechanism.start()
    zero = dict.fromkeys(start, 0.0)
    known: set[Pair] = set(allowed)
    for when, positions in (("at spawn", start), ("with all joints at 0", zero)):
        reachable = all(hinge.span[0] <= 0.0 <= hinge.span[1] for hinge in mechanism.hinges if hinge.moves)
        if positions is zero and (zero == start or not reachable):
            continue
        found = [pair for pair in overlapping(mechanism, shapes, positions) if frozenset(pair) not in known]
        known |= set(map(frozenset, found))
        if found:
            (link, other), more = found[0], len(found) - 1
            notes = (f"{more} more pair{'s' if more > 1 else ''} of links overlap",) if more else ()
            yield trouble_of(links_overlap, f"link:{link}", None, notes, link=link, other=other, when=when)


def overlapping(mechanism: Mechanism, shapes: Shapes, positions: Mapping[str, float]) -> list[tuple[str, str]]:
    """Return the pairs of links that overlap with the joints at some positions."""
    simple = {
        name: own for name, all_ in shapes.known.items() if (own := [shape for shape in all_ if shape.kind != "mesh"])
    }
    if len(simple) > MOST_LINKS:
        return []
    poses, bodies = mechanism.poses(positions), _bodies(mechanism, simple)
    placed = {name: [_PlacedShape(shape, poses[name]) for shape in own] for name, own in simple.items()}
    names = [name for name in mechanism.bodies if name in placed]
    return [
        (name, other)
        for n, name in enumerate(names)
        for other in names[n + 1 :]
        if not _neighbours(bodies, name, other) and any(_meet(a, b) for a in placed[name] for b in placed[other])
    ]


def _bodies(mechanism: Mechanism, simple: Collection[str]) -> dict[str, tuple[str, str]]:
    """The body that each link belongs to, and the body that carries it; bodies without shapes are skipped."""
    bodies = {mechanism.root: (mechanism.root, "")}
    solid = {mechanism.root: mechanism.root in simple}
    for hinge in mechanism.hinges:
        own, carrier = bodies[hinge.parent]
        if not hinge.moves:
            bodies[hinge.child] = own, carrier
            solid[own] = solid[own] or hinge.child in simple
        else:
            bodies[hinge.child] = hinge.child, own if solid[own] else carrier
            solid[hinge.child] = hinge.child in simple
    return bodies


def _neighbours(bodies: Mapping[str, tuple[str, str]], name: str, other: str) -> bool:
    """Whether two links belong to one body, or one is carried by the other directly or through one more body."""
    return bodies[name][0] in _near(bodies, other) or bodies[other][0] in _near(bodies, name)


def _near(bodies: Mapping[str, tuple[str, str]], name: str) -> tuple[str, ...]:
    """The body of a link, the one that carries it, and the one that carries that."""
    own, carrier = bodies[name]
    return own, carrier, bodies[carrier][1] if carrier else ""


class _PlacedShape:
    """A shape where its link is, with a sphere around it."""

    def __init__(self, shape: Shape, link: Pose) -> None:
        self._shape, self._link = shape, link
        self._back = transposed(link.turn)
        self.middle = link.at(shape.pose.place)
        half = [part / 2 for part in shape.size]
        self.thickness = min(shape.size)
        self.reach = {"box": math.hypot(*half), "cylinder": math.hypot(shape.size[0], half[-1])}.get(
            shape.kind, shape.size[0]
        )

    def farthest(self, way: Vector) -> Vector:
        """Return the farthest point in a direction of the shrunk shape."""
        point = self._link.at(self._shape.farthest(turned(self._back, way)))
        return plus(self.middle, scaled(minus(point, self.middle), SHRUNK))


def _meet(a: _PlacedShape, b: _PlacedShape) -> bool:
    """Whether two convex shapes have a point in common: the nearest point to 0 of all differences of their points.

    Gilbert's algorithm: it goes towards the support point against the nearest point so far, until a plane separates.
    """
    apart = minus(a.middle, b.middle)
    if dot(apart, apart) > (SHRUNK * (a.reach + b.reach)) ** 2:
        return False
    nearest, near = apart, _NEAR * min(a.thickness, b.thickness)
    for _ in range(_STEPS):
        if dot(nearest, nearest) < near * near:
            return True
        back = scaled(nearest, -1.0)
        support = minus(a.farthest(back), b.farthest(nearest))
        if dot(support, nearest) > 0:
            return False
        step = minus(nearest, support)
        part = min(1.0, dot(nearest, step) / dot(step, step))
        nearest = minus(nearest, scaled(step, part))
    return dot(nearest, nearest) < near * near
