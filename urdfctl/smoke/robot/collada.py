"""The corners of COLLADA meshes (.dae), as ROS and Gazebo place them: in metres, and without turning the up axis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice
from xml.etree import ElementTree as ET

from urdfctl.model.geometry import Vector, about, product, turned, unit

_Matrix = tuple[tuple[Vector, Vector, Vector], Vector]
"""The linear part of an affine map, and its shift."""
_MOST_NODES, _DEEPEST = 10_000, 100
_MOST_POINTS = 2_000_000
_SAME: _Matrix = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))


def corners_of_collada(data: bytes) -> list[Vector]:
    """Return the corners of all meshes in the scene of a COLLADA file, in m.

    Returns none if it cannot be read, or shows more nodes or corners than any mesh has.
    """
    try:
        scene = _Scene(data)
        given = scene.root.find("asset/unit")
        meter = float(given.get("meter", "1")) if given is not None else 1.0
        found = (_mapped(place, point) for mesh, place in scene.shown() for point in _positions(mesh, scene.by_id))
        points = list(islice(found, _MOST_POINTS + 1))
    except (ET.ParseError, ValueError, IndexError):
        return []
    return [(x * meter, y * meter, z * meter) for x, y, z in points] if len(points) <= _MOST_POINTS else []


def triangles_of_collada(data: bytes) -> tuple[list[Vector], list[tuple[int, int, int]]]:
    """Return the corners of all meshes in the scene of a COLLADA file, in m, and those of each triangle.

    Returns none under the conditions of `corners_of_collada`, or if its faces cannot be read.
    """
    points = corners_of_collada(data)
    if not points:
        return [], []
    try:
        scene, before = _Scene(data), 0
        faces: list[tuple[int, int, int]] = []
        for mesh, _ in scene.shown():
            count, starts = 0, {}
            for vertices in mesh.iterfind("mesh/vertices"):
                starts[vertices.get("id", "")] = before + count
                count += sum(1 for _ in _positions_of(vertices, scene.by_id))
            faces += _faces(mesh, starts)
            before += count
    except (ET.ParseError, ValueError, IndexError):
        return [], []
    fitting = all(0 <= corner < len(points) for face in faces for corner in face)
    return (points, faces) if fitting and before == len(points) else ([], [])


def shows_too_many_nodes(data: bytes) -> bool:
    """Return whether the scene of a COLLADA file is deeper or shows more nodes than that of any mesh."""
    try:
        for _ in _Scene(data).shown():
            pass
    except _TooManyNodes:
        return True
    except (ET.ParseError, ValueError, IndexError):
        return False
    return False


class _TooManyNodes(ValueError):
    """A few nodes that show each other twice describe more meshes than there are atoms."""


class _Scene:
    """The nodes of a COLLADA file. ParseError if it is no XML."""

    def __init__(self, data: bytes) -> None:
        self.root = ET.fromstring(data)  # noqa: S314 (expat limits what entities expand to)
        for element in self.root.iter():
            element.tag = element.tag.rpartition("}")[2]
        self.by_id = {identifier: element for element in self.root.iter() if (identifier := element.get("id"))}
        self._nodes = 0

    def shown(self) -> Iterator[tuple[ET.Element, _Matrix]]:
        """Yield each mesh that the scene shows, with its place. ValueError or IndexError if that cannot be read."""
        for scene in self.root.iter("visual_scene"):
            for node in scene.findall("node"):
                yield from self._by(node, _SAME)

    def _by(
        self, node: ET.Element, above: _Matrix, within: tuple[str, ...] = (), depth: int = 0
    ) -> Iterator[tuple[ET.Element, _Matrix]]:
        """Yield what a node shows. within: the names of the nodes that show it."""
        self._nodes += 1
        if self._nodes > _MOST_NODES or depth > _DEEPEST:
            raise _TooManyNodes
        here = above
        for child in node:
            if child.tag in _MAPS:
                here = _after(here, _MAPS[child.tag](_numbers(child)))
            elif child.tag == "node":
                yield from self._by(child, here, within, depth + 1)
            elif child.tag in ("instance_geometry", "instance_node"):
                name = child.get("url", "").lstrip("#")
                target = self.by_id.get(name)
                if target is not None and target.tag == "node":
                    yield from self._by(target, here, (*within, name), depth + 1) if name not in within else ()
                elif target is not None:
                    yield target, here


def _positions(geometry: ET.Element, by_id: Mapping[str, ET.Element]) -> Iterator[Vector]:
    for vertices in geometry.iterfind("mesh/vertices"):
        yield from _positions_of(vertices, by_id)


def _positions_of(vertices: ET.Element, by_id: Mapping[str, ET.Element]) -> Iterator[Vector]:
    for given in vertices.iterfind("input[@semantic='POSITION']"):
        source = by_id.get(given.get("source", "").lstrip("#"))
        array = source.find("float_array") if source is not None else None
        if source is None or array is None:
            continue
        accessor = source.find("technique_common/accessor")
        stride = int(accessor.get("stride", "3")) if accessor is not None else 3
        values = _numbers(array)
        for n in range(0, len(values) - 2, max(3, stride)):
            yield values[n], values[n + 1], values[n + 2]


def _faces(geometry: ET.Element, starts: Mapping[str, int]) -> Iterator[tuple[int, int, int]]:
    """The triangles of a mesh; a polygon is a fan of them. starts: where the corners of its vertices begin."""
    for kind in ("triangles", "polylist", "polygons"):
        for part in geometry.iterfind(f"mesh/{kind}"):
            inputs = part.findall("input")
            step = 1 + max((int(one.get("offset", "0")) for one in inputs), default=0)
            corner = next((one for one in inputs if one.get("semantic") == "VERTEX"), None)
            if corner is None:
                continue
            offset, start = int(corner.get("offset", "0")), starts.get(corner.get("source", "").lstrip("#"), 0)
            for row, sizes in _rows(part, kind, step):
                used, at = [int(word) + start for word in row[offset::step]], 0
                for size in sizes or [len(used)]:
                    yield from ((used[at], used[at + n], used[at + n + 1]) for n in range(1, size - 1))
                    at += size


def _rows(part: ET.Element, kind: str, step: int) -> Iterator[tuple[list[str], list[int]]]:
    """The indices of the faces of a part, and how many corners each has; one face if that is not said."""
    for listed in part.iterfind("p"):
        row = (listed.text or "").split()
        if kind == "polylist":
            yield row, [int(word) for word in (part.findtext("vcount") or "").split()]
        elif kind == "triangles":
            yield row, [3] * (len(row) // step // 3)
        else:
            yield row, []


def _numbers(element: ET.Element) -> list[float]:
    return [float(word) for word in (element.text or "").split()]


def _matrix(v: list[float]) -> _Matrix:
    return ((v[0], v[1], v[2]), (v[4], v[5], v[6]), (v[8], v[9], v[10])), (v[3], v[7], v[11])


def _translate(v: list[float]) -> _Matrix:
    return _SAME[0], (v[0], v[1], v[2])


def _scale(v: list[float]) -> _Matrix:
    return ((v[0], 0.0, 0.0), (0.0, v[1], 0.0), (0.0, 0.0, v[2])), _SAME[1]


def _rotate(v: list[float]) -> _Matrix:
    """About an axis, by an angle in degrees."""
    return about(unit((v[0], v[1], v[2])), math.radians(v[3])), _SAME[1]


_MAPS = {"matrix": _matrix, "translate": _translate, "scale": _scale, "rotate": _rotate}


def _mapped(matrix: _Matrix, point: Vector) -> Vector:
    x, y, z = turned(matrix[0], point)
    return x + matrix[1][0], y + matrix[1][1], z + matrix[1][2]


def _after(outer: _Matrix, inner: _Matrix) -> _Matrix:
    return product(outer[0], inner[0]), _mapped(outer, inner[1])
