"""The corners of COLLADA meshes (.dae), as ROS and Gazebo place them: in metres, and without turning the up axis."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree as ET

from urdfctl.model.geometry import Vector, about, product, turned, unit

_Matrix = tuple[tuple[Vector, Vector, Vector], Vector]
"""The linear part of an affine map, and its shift."""
_SAME: _Matrix = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))


def corners_of_collada(data: bytes) -> list[Vector]:
    """Return the corners of all meshes in the scene of a COLLADA file, in m; none if it cannot be read."""
    try:
        root = ET.fromstring(data)  # noqa: S314 (expat limits what entities expand to)
        for element in root.iter():
            element.tag = element.tag.rpartition("}")[2]
        by_id = {identifier: element for element in root.iter() if (identifier := element.get("id"))}
        given = root.find("asset/unit")
        meter = float(given.get("meter", "1")) if given is not None else 1.0
        scenes = [node for scene in root.iter("visual_scene") for node in scene.findall("node")]
        points = [point for node in scenes for point in _of_node(node, by_id, _SAME)]
    except (ET.ParseError, ValueError, IndexError):
        return []
    return [(x * meter, y * meter, z * meter) for x, y, z in points]


def _of_node(
    node: ET.Element, by_id: Mapping[str, ET.Element], above: _Matrix, shown: tuple[str, ...] = ()
) -> Iterator[Vector]:
    here = above
    for child in node:
        if child.tag in _MAPS:
            here = _after(here, _MAPS[child.tag](_numbers(child)))
        elif child.tag == "node":
            yield from _of_node(child, by_id, here, shown)
        elif child.tag in ("instance_geometry", "instance_node"):
            name = child.get("url", "").lstrip("#")
            target = by_id.get(name)
            if target is not None and target.tag == "node":
                yield from _of_node(target, by_id, here, (*shown, name)) if name not in shown else ()
            elif target is not None:
                yield from (_mapped(here, point) for point in _positions(target, by_id))


def _positions(geometry: ET.Element, by_id: Mapping[str, ET.Element]) -> Iterator[Vector]:
    for given in geometry.iterfind("mesh/vertices/input[@semantic='POSITION']"):
        source = by_id.get(given.get("source", "").lstrip("#"))
        array = source.find("float_array") if source is not None else None
        if source is None or array is None:
            continue
        accessor = source.find("technique_common/accessor")
        stride = int(accessor.get("stride", "3")) if accessor is not None else 3
        values = _numbers(array)
        for n in range(0, len(values) - 2, max(3, stride)):
            yield values[n], values[n + 1], values[n + 2]


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
