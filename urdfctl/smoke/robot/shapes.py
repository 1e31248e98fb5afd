"""Collision geometry in numbers: how far it reaches in a direction, and the wheel that it forms about an axis."""

from __future__ import annotations

import math
import os
import re
import struct
from collections.abc import Callable, Iterator, Mapping
from itertools import product

from urdfctl.model.geometry import Pose, Vector, cross, dot, minus, plus, scaled, transposed, turned, unit
from urdfctl.model.robot import Robot, Tag
from urdfctl.smoke.robot.description import numbers_of, origin_of
from urdfctl.smoke.robot.mechanism import Mechanism
from urdfctl.source.disk.gate import opened, size_of
from urdfctl.startup.records import NamedTuple

MOST_POINTS = 2000
"""At most this many corners of a mesh are looked at."""
_MOST_BYTES = 5 << 20
_ANGLES = 32


class Shape(NamedTuple):
    """A collision shape of a link.

    `kind` is `box`, `cylinder`, `sphere` or `mesh`. `pose` is that of its frame in the link's frame. `size` holds the
    dimensions of a box, or the radius and length of a cylinder, or the radius of a sphere, in m. `points` are the
    corners of a mesh, in m in the shape's frame.
    """

    kind: str
    pose: Pose
    size: tuple[float, ...] = ()
    points: tuple[Vector, ...] = ()

    def farthest(self, way: Vector) -> Vector:
        """Return the point of the shape that is farthest in a direction, in the link's frame."""
        return self.pose.at(self._farthest(turned(transposed(self.pose.turn), way)))

    def _farthest(self, way: Vector) -> Vector:
        if self.kind == "sphere":
            return scaled(way, self.size[0] / (math.sqrt(dot(way, way)) or 1.0))
        if self.kind == "box":
            x, y, z = (math.copysign(size / 2, part) for size, part in zip(self.size, way, strict=True))
            return x, y, z
        if self.kind == "cylinder":
            flat = math.hypot(way[0], way[1])
            out = self.size[0] / flat if flat > 1e-9 else 0.0  # noqa: PLR2004 (straight up or down)
            return way[0] * out, way[1] * out, math.copysign(self.size[1] / 2, way[2]) if abs(way[2]) > _LEVEL else 0.0
        return max(self.points, key=lambda point: dot(point, way))

    def outline(self) -> Iterator[Vector]:
        """Yield points that outline the shape, in the link's frame."""
        yield from map(self.pose.at, self._outline())

    def _outline(self) -> Iterator[Vector]:
        if self.kind == "box":
            for signs in product((-0.5, 0.5), repeat=3):
                x, y, z = (sign * size for sign, size in zip(signs, self.size, strict=True))
                yield x, y, z
        elif self.kind == "cylinder":
            radius, length = self.size
            for n, end in product(range(_ANGLES), (-0.5, 0.5)):
                angle = 2 * math.pi * n / _ANGLES
                yield radius * math.cos(angle), radius * math.sin(angle), end * length
        elif self.kind == "mesh":
            yield from self.points

    @property
    def volume(self) -> float:
        """Its volume in m³; that of a mesh is the volume of its bounding box."""
        if self.kind == "sphere":
            return 4 / 3 * math.pi * self.size[0] ** 3
        if self.kind == "cylinder":
            return math.pi * self.size[0] ** 2 * self.size[1]
        x, y, z = self.size if self.kind == "box" else self._extent()
        return x * y * z

    def _extent(self) -> Vector:
        x, y, z = (max(values) - min(values) for values in zip(*self.points, strict=True))
        return x, y, z


_LEVEL = 1e-6
"""A cylinder whose axis is as level as this touches the ground in the middle of its side."""


class Shapes(NamedTuple):
    """The collision shapes of a robot by link. `unknown` holds the links with a shape that could not be determined."""

    known: Mapping[str, tuple[Shape, ...]]
    unknown: frozenset[str] = frozenset()

    @property
    def complete(self) -> bool:
        """Whether the shapes of all links are known."""
        return not self.unknown


class WheelRim(NamedTuple):
    """The part of a wheel that rolls: its radius, its place and width along the axis, and how far its middle is from
    the axis, all in m."""

    radius: float
    place: float
    width: float
    off: float = 0.0


def shapes_of(robot: Robot, find_mesh: Callable[[str], str | None] | None = None, role: str = "collision") -> Shapes:
    """Return the shapes of a robot, `collision` or `visual`. Without `find_mesh` meshes are not looked for."""
    known: dict[str, tuple[Shape, ...]] = {}
    unknown = set()
    for link in robot.links:
        name = link.name or ""
        found = [_shape(tag, find_mesh) for tag in link.tag.named(role)]
        known[name] = tuple(shape for shape in found if shape is not None)
        if None in found:
            unknown.add(name)
    return Shapes(known, frozenset(unknown))


def _shape(collision: Tag, find_mesh: Callable[[str], str | None] | None) -> Shape | None:
    geometry = next(collision.named("geometry"), None)
    tag = geometry.children[0] if geometry and geometry.children else None
    if tag is None:
        return None
    pose = origin_of(collision)
    if tag.name == "mesh":
        path = find_mesh(tag.attributes.get("filename", "")) if find_mesh else None
        scale = numbers_of(tag.attributes.get("scale", "1 1 1"))
        points = tuple(_scaled(point, scale) for point in corners_of(path)) if path else ()
        return Shape("mesh", pose, (), points) if points else None
    names = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}.get(tag.name, ())
    texts = " ".join(tag.attributes.get(name, "") for name in names).split()
    try:
        size = tuple(map(float, texts))
    except ValueError:
        return None
    wanted = 3 if tag.name == "box" else len(names)
    return Shape(tag.name, pose, size) if len(size) == wanted > 0 and all(0 < s < math.inf for s in size) else None


def _scaled(point: Vector, scale: Vector) -> Vector:
    return point[0] * scale[0], point[1] * scale[1], point[2] * scale[2]


def rim_of(shapes: tuple[Shape, ...], axis: Vector) -> WheelRim | None:
    """Return the wheel that the shapes of a link form about an axis through its origin; None without any shape."""
    best: WheelRim | None = None
    for shape in shapes:
        rim = _rim(shape, axis)
        if best is None or rim.radius > best.radius:
            best = rim
    return best


def _rim(shape: Shape, axis: Vector) -> WheelRim:
    if shape.kind == "sphere":
        away, along = _split(shape.pose.place, axis)
        return WheelRim(away + shape.size[0], along, 0.0, away)
    points = [_split(point, axis) for point in shape.outline()]
    radius = max(away for away, _ in points)
    outer = [along for away, along in points if away > 0.98 * radius]
    return WheelRim(radius, (max(outer) + min(outer)) / 2, max(outer) - min(outer), _off(shape, axis))


def _off(shape: Shape, axis: Vector) -> float:
    """The distance of the middle of a shape from an axis through the origin."""
    one = unit(cross(axis, (1.0, 0.0, 0.0) if abs(axis[0]) < 0.9 else (0.0, 1.0, 0.0)))  # noqa: PLR2004 (not parallel)
    sides = (one, cross(axis, one))
    middles = ((dot(shape.farthest(way), way) - dot(shape.farthest(scaled(way, -1)), scaled(way, -1))) for way in sides)
    return math.hypot(*middles) / 2


def with_rims(mechanism: Mechanism, shapes: Shapes) -> Mechanism:
    """Return a mechanism in which each link that turns has the radius of its collision geometry."""
    bodies = dict(mechanism.bodies)
    for hinge in mechanism.hinges:
        rim = rim_of(shapes.known.get(hinge.child, ()), hinge.axis) if hinge.moves else None
        if rim:
            bodies[hinge.child] = bodies[hinge.child]._replace(
                radius=rim.radius, aside=rim.place, width=rim.width, off=rim.off
            )
    return mechanism._replace(bodies=bodies)


def _split(point: Vector, axis: Vector) -> tuple[float, float]:
    """The distance of a point from an axis through the origin, and its place along the axis."""
    along = dot(point, axis)
    rest = minus(point, scaled(axis, along))
    return math.sqrt(dot(rest, rest)), along


# -- meshes ----------------------------------------------------------------------------------------------------------


def corners_of(path: str) -> tuple[Vector, ...]:
    """Return corners of a mesh that its convex hull needs, as far as they can be read: of STL, OBJ and DAE files."""
    try:
        if size_of(path) > _MOST_BYTES:
            return ()
        with opened(path) as file:
            data = file.read(_MOST_BYTES)
    except OSError:
        return ()
    kind = os.path.splitext(path)[1].lower()
    readers: dict[str, Callable[[bytes], list[Vector]]] = {".stl": _of_stl, ".obj": _of_obj, ".dae": _of_dae}
    points = readers[kind](data) if kind in readers else []
    unique = list(dict.fromkeys(points))
    if not all(map(math.isfinite, (part for point in unique for part in point))):
        return ()
    return tuple(unique) if len(unique) <= MOST_POINTS else tuple(_outermost(unique))


def _of_stl(data: bytes) -> list[Vector]:
    if data[:5].lower() == b"solid" and b"facet" in data[:1000]:
        return [_triple(found.groups()) for found in re.finditer(rb"vertex\s+(\S+)\s+(\S+)\s+(\S+)", data)]
    count = int.from_bytes(data[80:84], "little")
    if len(data) < 84 + 50 * count:
        return []
    triangles = struct.iter_unpack("<12x9f2x", data[84 : 84 + 50 * count])
    return [corner for t in triangles for corner in ((t[0], t[1], t[2]), (t[3], t[4], t[5]), (t[6], t[7], t[8]))]


def _of_obj(data: bytes) -> list[Vector]:
    return [_triple(found.groups()) for found in re.finditer(rb"(?m)^v\s+(\S+)\s+(\S+)\s+(\S+)", data)]


def is_endless(data: bytes, kind: str) -> bool:
    """Return whether a mesh file shows more nodes than any mesh has. kind: the end of its name, without the dot."""
    from urdfctl.smoke.robot.collada import shows_too_many_nodes

    return kind == "dae" and shows_too_many_nodes(data)


def _of_dae(data: bytes) -> list[Vector]:
    from urdfctl.smoke.robot.collada import corners_of_collada

    return corners_of_collada(data)


def _triple(words: tuple[bytes, ...]) -> Vector:
    try:
        x, y, z = map(float, words)
    except ValueError:
        return math.nan, math.nan, math.nan
    return x, y, z


def _outermost(points: list[Vector]) -> Iterator[Vector]:
    """The farthest corner from the middle in each of some hundred cones, which cover the sphere, and those that lie
    farthest along the axes. Scanner meshes have a hundred thousand corners."""
    x0, y0, z0 = scaled(_total(points), 1 / len(points))
    farthest: dict[tuple[int, int], tuple[float, Vector]] = {}
    for point in points:
        x, y, z = point[0] - x0, point[1] - y0, point[2] - z0
        distance = x * x + y * y + z * z
        around = int((math.atan2(y, x) / math.pi + 1) * _MERIDIANS)
        cone = around, int((z / math.sqrt(distance) + 1) * _PARALLELS) if distance else 0
        if cone not in farthest or distance > farthest[cone][0]:
            farthest[cone] = distance, point
    yield from (point for _, point in farthest.values())
    for axis in range(3):
        yield min(points, key=lambda point, axis=axis: point[axis])  # type: ignore[misc]
        yield max(points, key=lambda point, axis=axis: point[axis])  # type: ignore[misc]


_MERIDIANS, _PARALLELS = 16, 6
"""Half the number of cones around the z axis, and from pole to pole."""


def _total(points: list[Vector]) -> Vector:
    total: Vector = (0.0, 0.0, 0.0)
    for point in points:
        total = plus(total, point)
    return total
