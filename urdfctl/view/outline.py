"""The robot's shape at spawn as line segments: lines between its joints, and outlines of the links' simple shapes."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from urdfctl.model.geometry import Pose, Vector
from urdfctl.model.robot import Robot, Tag
from urdfctl.smoke.robot import Mechanism, numbers_of, origin_of

Segment = tuple[float, ...]
MOST_SEGMENTS = 4000
_CORNERS = 16


def outline_of(robot: Robot, mechanism: Mechanism) -> tuple[Segment, ...]:
    """Return the segments, each as (x1, y1, z1, x2, y2, z2) in m in the root's frame."""
    poses = mechanism.poses(mechanism.start())
    segments: list[Segment] = []
    for hinge in mechanism.hinges:
        ends = poses[hinge.parent].place, poses[hinge.child].place
        if ends[0] != ends[1]:
            segments.append(_segment(*ends))
    for link in robot.links:
        for role in ("visual", "collision"):
            outlines = [line for tag in link.tag.named(role) for line in _outline(tag, poses[link.name or ""])]
            segments += outlines
            if outlines:
                break
    return tuple(segments[:MOST_SEGMENTS])


def _segment(start: Vector, end: Vector) -> Segment:
    return tuple(round(part, 4) for part in (*start, *end))


def _outline(tag: Tag, link: Pose) -> Iterator[Segment]:
    geometry = next(tag.named("geometry"), None)
    shape = geometry.children[0] if geometry and geometry.children else None
    if shape is None:
        return
    pose = link.then(origin_of(tag))
    sizes = [numbers_of(shape.attributes.get(name, "")) for name in ("size", "radius", "length")]
    size, radius, length = sizes[0], sizes[1][0], sizes[2][0]
    if shape.name == "box":
        yield from _box(pose, size)
    elif shape.name == "cylinder":
        yield from _ring(pose, radius, "xy", length / 2)
        yield from _ring(pose, radius, "xy", -length / 2)
        for angle in range(0, _CORNERS, 4):
            x, y = _on_circle(radius, angle)
            yield _segment(pose.at((x, y, -length / 2)), pose.at((x, y, length / 2)))
    elif shape.name == "sphere":
        for plane in ("xy", "xz", "yz"):
            yield from _ring(pose, radius, plane, 0.0)


def _box(pose: Pose, size: Vector) -> Iterator[Segment]:
    half = [part / 2 for part in size]
    corners = [(x * half[0], y * half[1], z * half[2]) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    for n, corner in enumerate(corners):
        for other in corners[n + 1 :]:
            if sum(a != b for a, b in zip(corner, other, strict=True)) == 1:
                yield _segment(pose.at(corner), pose.at(other))


def _ring(pose: Pose, radius: float, plane: str, off: float) -> Iterator[Segment]:
    points = []
    for n in range(_CORNERS + 1):
        a, b = _on_circle(radius, n)
        points.append(pose.at({"xy": (a, b, off), "xz": (a, off, b), "yz": (off, a, b)}[plane]))
    for start, end in pairwise(points):
        yield _segment(start, end)


def _on_circle(radius: float, n: int) -> tuple[float, float]:
    angle = 2 * math.pi * n / _CORNERS
    return radius * math.cos(angle), radius * math.sin(angle)
