"""Measure where a robot's joints are and what load they carry, with all joints at zero."""

from __future__ import annotations

import math
from collections.abc import Iterator

from urdfctl.model.geometry import (
    ZERO,
    Pose,
    Rotation,
    Vector,
    cross,
    dot,
    of_angles,
    plus,
    product,
    scaled,
    transposed,
    turned,
)
from urdfctl.model.robot import Geometry, Joint, Link, Robot, Tag
from urdfctl.startup.records import NamedTuple


class Bulk(NamedTuple):
    """Mass, first moment, and inertia about the root's origin. All three can be added."""

    mass: float
    moment: Vector
    inertia: Rotation

    def plus(self, other: Bulk) -> Bulk:
        """Return the sum of both."""
        rows = [plus(mine, theirs) for mine, theirs in zip(self.inertia, other.inertia, strict=True)]
        return Bulk(self.mass + other.mass, plus(self.moment, other.moment), (rows[0], rows[1], rows[2]))

    def about(self, point: Vector, axis: Vector) -> float:
        """Return the inertia about an axis through a point, in kg m2."""
        away = cross(axis, point)
        whole = dot(axis, turned(self.inertia, axis))
        return whole - 2 * dot(away, cross(axis, self.moment)) + self.mass * dot(away, away)


NOTHING = Bulk(0.0, ZERO, (ZERO, ZERO, ZERO))


class Measured(NamedTuple):
    """A joint's position and axis in the root's frame, and the inertia that it moves."""

    at: Vector
    axis: Vector
    inertia: float | None


def measured(robot: Robot) -> dict[str, Measured]:
    """Return the measurements of each joint below the root, by name."""
    links = {link.name: link for link in robot.links if link.name}
    frames = frames_of(robot)
    bulks = {name: bulk_of(links.get(name), frame) for name, frame in frames.items()}
    measurements: dict[str, Measured] = {}
    for joint, parent, child in reversed(list(outwards(robot))):
        carried, frame = bulks[child], frames[child]
        axis = axis_of(joint, frame)
        inertia = carried.mass if joint.type == "prismatic" else carried.about(frame.place, axis)
        if joint.name:
            measurements[joint.name] = Measured(frame.place, axis, inertia if inertia > 0 else None)
        bulks[parent] = bulks[parent].plus(carried)
    return measurements


def frames_of(robot: Robot) -> dict[str, Pose]:
    """Return the pose of each link that the root reaches, in the root's frame, with all joints at zero."""
    root = root_of(robot)
    frames = {root: Pose()} if root else {}
    for joint, parent, child in outwards(robot):
        frames[child] = frames[parent].then(origin_of(next(joint.tag.named("origin"), None)))
    return frames


def geometries_of(link: Link | None) -> Iterator[tuple[Geometry, Tag]]:
    """Yield the geometry of a link, with the elements that contain it."""
    if link is None:
        return
    for role in ("visual", "collision"):
        of_role = [geometry for geometry in link.geometries if geometry.role == role]
        yield from zip(of_role, link.tag.named(role), strict=False)


def root_of(robot: Robot) -> str | None:
    """Return the name of the root link, which is the child of no joint."""
    children = {joint.child.name for joint in robot.joints if joint.child}
    return next((link.name for link in robot.links if link.name not in children), None)


def outwards(robot: Robot) -> Iterator[tuple[Joint, str, str]]:
    """Yield the joints with parent and child link, from the root outwards.

    Joints that the root does not reach are left out.
    """
    below: dict[str, list[tuple[Joint, str]]] = {}
    for joint in robot.joints:
        if joint.parent and joint.child and joint.parent.name and joint.child.name:
            below.setdefault(joint.parent.name, []).append((joint, joint.child.name))
    reached = {root_of(robot) or ""}
    pending = list(reached)
    while pending:
        link = pending.pop()
        for joint, child in below.get(link, ()):
            if child not in reached:
                reached.add(child)
                pending.append(child)
                yield joint, link, child


def bulk_of(link: Link | None, frame: Pose) -> Bulk:
    """Return the mass of a link at a pose in the root's frame."""
    inertial = link.inertials[0] if link and link.inertials else None
    mass = inertial.mass.value if inertial and inertial.mass else None
    if inertial is None or link is None or not mass:
        return NOTHING
    element = next(link.tag.named("inertial"), None)
    own = frame.then(origin_of(next(element.named("origin"), None) if element else None))
    values = {name: number.value or 0.0 for name, number in (inertial.inertia or {}).items()}
    xx, xy, xz = (values.get(name, 0.0) for name in ("ixx", "ixy", "ixz"))
    yy, yz, zz = (values.get(name, 0.0) for name in ("iyy", "iyz", "izz"))
    turned_inertia = product(product(own.turn, ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))), transposed(own.turn))
    x, y, z = own.place
    steiner = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
    rows = [plus(row, scaled(more, mass)) for row, more in zip(turned_inertia, steiner, strict=True)]
    return Bulk(mass, scaled(own.place, mass), (rows[0], rows[1], rows[2]))


def axis_of(joint: Joint, frame: Pose) -> Vector:
    """Return the axis of a joint, of length 1, turned as the frame of its child."""
    axis = _vector(joint.axis.text if joint.axis else None, (1.0, 0.0, 0.0))
    length = math.sqrt(dot(axis, axis))
    return turned(frame.turn, scaled(axis, 1 / length)) if length else (1.0, 0.0, 0.0)


def origin_of(tag: Tag | None) -> Pose:
    """Return the pose in an `<origin>` element; no element means no offset."""
    attributes = tag.attributes if tag else {}
    return Pose(_vector(attributes.get("xyz"), ZERO), of_angles(*_vector(attributes.get("rpy"), ZERO)))


def _vector(text: str | None, otherwise: Vector) -> Vector:
    numbers = [number_of(part) for part in (text or "").split()]
    if len(numbers) != 3 or None in numbers:  # noqa: PLR2004
        return otherwise
    x, y, z = (number or 0.0 for number in numbers)
    return x, y, z


def number_of(text: str | None) -> float | None:
    """Return a finite number, or None if a text is none."""
    try:
        value = float(text or "")
    except ValueError:
        return None
    return value if math.isfinite(value) else None
