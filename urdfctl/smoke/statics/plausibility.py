"""The units of a robot, by its own proportions: limits and rotations in degrees, lengths in mm, masses in g."""

from __future__ import annotations

import math
import statistics
from collections.abc import Iterator, Mapping, Sequence

from urdfctl.model.degrees import are_limits_in_degrees, is_rotation_in_degrees
from urdfctl.model.geometry import Vector, minus
from urdfctl.model.robot import Robot, Tag
from urdfctl.rules.smoke.angles_in_degrees import angles_in_degrees
from urdfctl.rules.smoke.length_in_millimetres import length_in_millimetres
from urdfctl.rules.smoke.limits_in_degrees import limits_in_degrees
from urdfctl.rules.smoke.mass_in_grams import mass_in_grams
from urdfctl.rules.smoke.mass_outside_of_link import mass_outside_of_link
from urdfctl.rules.smoke.travel_in_millimetres import travel_in_millimetres
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism, Shapes, numbers_of
from urdfctl.startup.records import NamedTuple

DENSEST = 25_000.0
"""The density that no material has, in kg/m³: osmium has 22 600."""
HOLLOW = 20.0
"""The density of a part that is mostly air, in kg/m³."""
MUCH_LARGER = 30.0
"""A part that is this much larger than those of its robot usually are is in another unit."""
LEAST_LENGTH = 3.0
"""Shorter lengths are not taken for mm, in m."""
FARTHEST = 5.0
"""A joint travels at most so many times the length of its robot."""
NOT_LARGER = 20.0
"""A part is at most this much larger than those of its robot usually are, if its unit is right."""
FAR_OUTSIDE = 5.0
"""A centre of mass is in its link, or outside of it by less than so many times the size of the link."""
HEAVY = 10.0
"""A part in grams has at least so many times the mass of the usual part of its robot."""
LEAST_SIZE = 0.02
"""Smaller links count as large as this, in m: their shapes are often only marks."""
LEAST_LENGTHS = 3
"""A robot of which fewer lengths are known has no usual one."""


class Extent(NamedTuple):
    """The box around the shapes of a link along the axes of the link's frame, in m."""

    low: Vector
    high: Vector

    @property
    def size(self) -> float:
        """The length of its diagonal."""
        return math.dist(self.low, self.high)

    @property
    def thickness(self) -> float:
        """Its shortest side: a rail is long, but not thick."""
        return min(high - low for low, high in zip(self.low, self.high, strict=True))

    @property
    def volume(self) -> float:
        """Its volume in m³; a sheet counts as 1 mm thick."""
        return math.prod(max(high - low, 1e-3) for low, high in zip(self.low, self.high, strict=True))

    def away(self, point: Vector) -> float:
        """Return the distance of a point from the box, 0 inside."""
        outside = (max(a - x, 0.0, x - b) for a, x, b in zip(self.low, point, self.high, strict=True))
        return math.hypot(*outside)

    def around(self, points: Sequence[Vector]) -> Extent:
        """Return the box around this one and some points."""
        every = (self.low, self.high, *points)
        (x, y, z), (x2, y2, z2) = ([way([p[n] for p in every]) for n in range(3)] for way in (min, max))
        return Extent((x, y, z), (x2, y2, z2))


def plausibility_troubles(mechanism: Mechanism, robot: Robot, shapes: Shapes, visuals: Shapes) -> Iterator[Trouble]:
    """Yield the numbers of a robot that are most likely in another unit, each with the value that was meant.

    shapes, visuals: the collision shapes, and those that are seen.
    """
    extents = extents_of(mechanism, shapes, visuals)
    yield from _limits(mechanism)
    yield from _rotations(robot)
    usual = _usual_size(mechanism, extents)
    if usual is None:
        return
    whole = _whole_size(mechanism, extents, usual)
    yield from _travels(mechanism, extents, whole)
    yield from _lengths(mechanism, extents, usual)
    yield from _centres(mechanism, extents)
    yield from _masses(mechanism, extents)


# -- sizes -----------------------------------------------------------------------------------------------------------


def extents_of(mechanism: Mechanism, shapes: Shapes, visuals: Shapes) -> dict[str, Extent]:
    """Return the extent of each link of which all shapes are known and have corners or a size."""
    found = {}
    for name in mechanism.bodies:
        if name in shapes.unknown or name in visuals.unknown:
            continue
        points = []
        for shape in (*shapes.known.get(name, ()), *visuals.known.get(name, ())):
            for axis in range(3):
                for sign in (-1.0, 1.0):
                    way = [0.0, 0.0, 0.0]
                    way[axis] = sign
                    points.append(shape.farthest((way[0], way[1], way[2])))
        if points:
            found[name] = Extent(points[0], points[0]).around(points)
    return found


def _usual_size(mechanism: Mechanism, extents: Mapping[str, Extent]) -> float | None:
    """The usual length of a link: of its shapes, or up to its next joint; None if too few are known."""
    lengths = [math.hypot(*hinge.pose.place) for hinge in mechanism.hinges]
    known = [length for length in (*(extent.size for extent in extents.values()), *lengths) if length > LEAST_SIZE]
    return statistics.median(known) if len(known) >= LEAST_LENGTHS else None


def _whole_size(mechanism: Mechanism, extents: Mapping[str, Extent], usual: float) -> float:
    """A length that the whole robot does not have from end to end, without what is in another unit."""
    lengths = [math.hypot(*hinge.pose.place) for hinge in mechanism.hinges]
    sizes = [extent.size for extent in extents.values() if extent.thickness < usual]
    return sum(sizes) + sum(length for length in lengths if not _is_in_millimetres(length, usual))


def _is_solid(mechanism: Mechanism, extents: Mapping[str, Extent], link: str) -> bool:
    """Whether a link is a part of the robot, and not a place in the world."""
    above = {link, *(hinge.parent for hinge in mechanism.above(link))}
    return any(mechanism.bodies[name].mass > 0 or name in extents for name in above)


# -- angles ----------------------------------------------------------------------------------------------------------


def _limits(mechanism: Mechanism) -> Iterator[Trouble]:
    """The limits of revolute joints in degrees."""
    for hinge in mechanism.hinges:
        limits = [limit for limit in (hinge.lower, hinge.upper) if limit is not None]
        if not are_limits_in_degrees(hinge.type, limits):
            continue
        fields = {"joint": hinge.name, "lower": limits[0], "upper": limits[-1]}
        yield trouble_of(limits_in_degrees, f"joint:{hinge.name}", None, (), **fields)


def _rotations(robot: Robot) -> Iterator[Trouble]:
    for joint in robot.joints:
        yield from _rotation(joint.tag, f"joint:{joint.name}", f"joint '{joint.name}'")
    for link in robot.links:
        for part in ("inertial", "visual", "collision"):
            for tag in link.tag.named(part):
                yield from _rotation(tag, f"link:{link.name}", f"<{part}> of link '{link.name}'")


def _rotation(tag: Tag, subject: str, what: str) -> Iterator[Trouble]:
    origin = next(tag.named("origin"), None)
    given = numbers_of(origin.attributes.get("rpy", "")) if origin else (0.0, 0.0, 0.0)
    if is_rotation_in_degrees(given):
        yield trouble_of(angles_in_degrees, subject, None, (), part=what, angles=given)


# -- lengths and masses ----------------------------------------------------------------------------------------------


def _travels(mechanism: Mechanism, extents: Mapping[str, Extent], whole: float) -> Iterator[Trouble]:
    for hinge in mechanism.hinges:
        low, high = hinge.lower or 0.0, hinge.upper or 0.0
        travel = high - low
        if hinge.type != "prismatic" or not math.isfinite(travel) or not _is_solid(mechanism, extents, hinge.parent):
            continue
        beside = [extents[name].size for name in (hinge.parent, hinge.child) if name in extents]
        most = min(FARTHEST * whole, MUCH_LARGER * sum(beside) if len(beside) > 1 else math.inf)
        if travel > max(most, LEAST_LENGTH) and travel / 1000 <= whole:
            fields = {"joint": hinge.name, "travel": travel, "size": whole}
            meant = {"least": low / 1000, "most": high / 1000}
            yield trouble_of(travel_in_millimetres, f"joint:{hinge.name}", None, (), **fields, **meant)


def _lengths(mechanism: Mechanism, extents: Mapping[str, Extent], usual: float) -> Iterator[Trouble]:
    """Shapes and mounting places whose numbers are in mm."""
    for name, extent in extents.items():
        if _is_in_millimetres(extent.size, usual) and extent.thickness > usual:
            fields = {"part": f"link '{name}' is", "length": extent.size, "usual": usual}
            yield trouble_of(length_in_millimetres, f"link:{name}", None, (), **fields)
    for hinge in mechanism.hinges:
        place = math.hypot(*hinge.pose.place)
        if _is_in_millimetres(place, usual) and _is_solid(mechanism, extents, hinge.parent):
            fields = {"part": f"joint '{hinge.name}' is away from its parent", "length": place, "usual": usual}
            yield trouble_of(length_in_millimetres, f"joint:{hinge.name}", None, (), **fields)


def _is_in_millimetres(length: float, usual: float) -> bool:
    return length > max(MUCH_LARGER * usual, LEAST_LENGTH) and length / 1000 < NOT_LARGER * usual


def _centres(mechanism: Mechanism, extents: Mapping[str, Extent]) -> Iterator[Trouble]:
    for name, extent in extents.items():
        body = mechanism.bodies[name]
        ends = [hinge.pose.place for hinge in mechanism.hinges if hinge.parent == name and not _is_odd(hinge, extents)]
        around = extent.around([(0.0, 0.0, 0.0), *ends])
        size = max(around.size, LEAST_SIZE)
        away = around.away(body.centre)
        if not body.mass or not away > FAR_OUTSIDE * size:
            continue
        x, y, z = (part / 1000 for part in body.centre)
        if away > NOT_LARGER * size and around.away((x, y, z)) <= 0.1 * size:
            fields = {"part": f"centre of mass of link '{name}' is", "length": math.hypot(*body.centre), "usual": size}
            yield trouble_of(length_in_millimetres, f"link:{name}", None, (), **fields)
        else:
            fields = {"link": name, "away": away, "size": size}
            yield trouble_of(mass_outside_of_link, f"link:{name}", None, (), **fields)


def _is_odd(hinge: Hinge, extents: Mapping[str, Extent]) -> bool:
    """Whether the place of a joint is itself in another unit."""
    extent = extents.get(hinge.parent)
    return extent is not None and math.hypot(*minus(hinge.pose.place, extent.low)) > MUCH_LARGER * extent.size


def _masses(mechanism: Mechanism, extents: Mapping[str, Extent]) -> Iterator[Trouble]:
    masses = [body.mass for body in mechanism.bodies.values() if body.mass > 0]
    usual = statistics.median(masses) if masses else 0.0
    for name, extent in extents.items():
        mass = mechanism.bodies[name].mass
        density = mass / extent.volume
        if density > DENSEST and mass > HEAVY * usual and HOLLOW < density / 1000 < DENSEST:
            fields = {"link": name, "mass": mass, "litres": extent.volume * 1000, "times": density / 11_340}
            yield trouble_of(mass_in_grams, f"link:{name}", None, (), **fields)
