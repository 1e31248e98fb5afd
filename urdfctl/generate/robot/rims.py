"""The wheels that links form: their radius, and the middle of their tread, from their geometry."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterator, Sequence

from urdfctl.generate.robot.frames import geometries_of, number_of, origin_of
from urdfctl.model.geometry import Pose, Vector, dot, minus, scaled
from urdfctl.model.robot import Joint, Link, Tag
from urdfctl.startup.records import NamedTuple

Corners = Callable[[str], Sequence[Vector]]
"""Returns corners of a mesh, given its address, in its own units; none if it cannot be read."""
_WHEEL = re.compile(r"wheel|tire|tyre", re.IGNORECASE)


class Rim(NamedTuple):
    """The radius of a wheel, in m, and the middle of its tread in the link's frame."""

    radius: float
    middle: Vector


def no_corners(_: str) -> Sequence[Vector]:
    """Return no corners: meshes are not read."""
    return ()


def rim_of(joint: Joint, link: Link | None, axis: Vector, corners: Corners = no_corners) -> Rim | None:
    """Return the wheel that a link forms about an axis through its origin; None if it has no round shape.

    Collision geometry comes first. Of cylinders and spheres, the largest one counts; meshes only of what is called a
    wheel.
    """
    for role in ("collision", "visual"):
        shapes = [(one.shape, _pose(tag)) for one, tag in geometries_of(link) if one.role == role and one.shape]
        rims = [Rim(radius, pose.place) for shape, pose in shapes if (radius := _radius(shape))]
        if not rims and joint.type == "continuous" and _is_called_wheel(joint, link, [shape for shape, _ in shapes]):
            points = [point for shape, pose in shapes for point in _points(shape, pose, corners)]
            rims = [_of_points(points, axis)] if points else []
        if rims:
            return max(rims, key=lambda rim: rim.radius)
    return None


def _is_called_wheel(joint: Joint, link: Link | None, shapes: Sequence[Tag]) -> bool:
    """Whether the name of a joint, of its link, or of the file of a mesh is that of a wheel."""
    files = (os.path.basename(shape.attributes.get("filename", "")) for shape in shapes)
    return any(_WHEEL.search(name) for name in (joint.name or "", link.name or "" if link else "", *files))


def _pose(tag: Tag) -> Pose:
    return origin_of(next(tag.named("origin"), None))


def _radius(shape: Tag) -> float | None:
    return number_of(shape.attributes.get("radius")) if shape.name in ("cylinder", "sphere") else None


def _points(shape: Tag, pose: Pose, corners: Corners) -> Iterator[Vector]:
    if shape.name != "mesh":
        return
    factors = [number_of(word) for word in shape.attributes.get("scale", "1 1 1").split()]
    x, y, z = (factor or 1.0 for factor in factors) if len(factors) == 3 else (1.0, 1.0, 1.0)  # noqa: PLR2004
    for point in corners(shape.attributes.get("filename", "")):
        yield pose.at((point[0] * x, point[1] * y, point[2] * z))


def _of_points(points: Sequence[Vector], axis: Vector) -> Rim:
    """The wheel of a mesh, whose middle is on the axis."""
    along = [dot(point, axis) for point in points]
    away = [minus(point, scaled(axis, part)) for point, part in zip(points, along, strict=True)]
    radius = math.sqrt(max(dot(one, one) for one in away))
    return Rim(float(f"{radius:.5g}"), scaled(axis, (min(along) + max(along)) / 2))
