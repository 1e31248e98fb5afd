"""Where a robot's joints are, and what they carry, with all joints at zero."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from urdfctl.generate.facts import Vector
from urdfctl.model.parts import Tag
from urdfctl.model.robot import Joint, Link, Robot
from urdfctl.record import NamedTuple

Matrix = tuple[Vector, Vector, Vector]
_ZERO: Vector = (0.0, 0.0, 0.0)
_UNIT: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Frame(NamedTuple):
    """A rotation, then a shift, from a link's frame to the root's."""

    rotation: Matrix
    shift: Vector

    def then(self, xyz: Vector, rpy: Vector) -> Frame:
        """The frame of an origin that is given in this one."""
        return Frame(_product(self.rotation, _rotation(rpy)), _sum(_turned(self.rotation, xyz), self.shift))


class Bulk(NamedTuple):
    """Mass, its first moment, and its inertia about the root's origin; these add up."""

    mass: float
    moment: Vector
    inertia: Matrix

    def plus(self, other: Bulk) -> Bulk:
        """Both together."""
        rows = [_sum(mine, theirs) for mine, theirs in zip(self.inertia, other.inertia, strict=True)]
        return Bulk(self.mass + other.mass, _sum(self.moment, other.moment), (rows[0], rows[1], rows[2]))

    def about(self, point: Vector, axis: Vector) -> float:
        """The inertia about an axis through a point, in kg m2."""
        away = _cross(axis, point)
        whole = _dot(axis, _turned(self.inertia, axis))
        return whole - 2 * _dot(away, _cross(axis, self.moment)) + self.mass * _dot(away, away)


_NOTHING = Bulk(0.0, _ZERO, (_ZERO, _ZERO, _ZERO))


class Measured(NamedTuple):
    """Of a joint: where it is and its axis, in the root's frame, what it carries, and its wheel's radius."""

    at: Vector
    axis: Vector
    inertia: float | None
    radius: float | None


def measured(robot: Robot) -> dict[str, Measured]:
    """What can be measured of each joint below the root, by name."""
    links = {link.name: link for link in robot.links if link.name}
    order = list(_outwards(robot))
    frames: dict[str, Frame] = {}
    placed: list[tuple[Joint, str, str, Frame]] = []
    for joint, parent, child in order:
        above = frames.setdefault(parent, Frame(_UNIT, _ZERO))
        frames[child] = above.then(*_origin(next(joint.tag.named("origin"), None)))
        placed.append((joint, parent, child, frames[child]))
    bulks = {name: _bulk(links.get(name), frame) for name, frame in frames.items()}
    found: dict[str, Measured] = {}
    for joint, parent, child, frame in reversed(placed):
        carried = bulks[child]
        axis = _axis(joint, frame)
        inertia = carried.mass if joint.type == "prismatic" else carried.about(frame.shift, axis)
        if joint.name:
            radius = _radius(links.get(child))
            found[joint.name] = Measured(frame.shift, axis, inertia if inertia > 0 else None, radius)
        bulks[parent] = bulks[parent].plus(carried)
    return found


def root_of(robot: Robot) -> str | None:
    """The link that no joint moves."""
    children = {joint.child.name for joint in robot.joints if joint.child}
    return next((link.name for link in robot.links if link.name not in children), None)


def _outwards(robot: Robot) -> Iterator[tuple[Joint, str, str]]:
    """The joints with their links, each after those that carry it; none that hang in no tree."""
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


def _bulk(link: Link | None, frame: Frame) -> Bulk:
    inertial = link.inertials[0] if link and link.inertials else None
    mass = inertial.mass.value if inertial and inertial.mass else None
    if inertial is None or link is None or not mass:
        return _NOTHING
    element = next(link.tag.named("inertial"), None)
    own = frame.then(*_origin(next(element.named("origin"), None) if element else None))
    values = {name: number.value or 0.0 for name, number in (inertial.inertia or {}).items()}
    xx, xy, xz = (values.get(name, 0.0) for name in ("ixx", "ixy", "ixz"))
    yy, yz, zz = (values.get(name, 0.0) for name in ("iyy", "iyz", "izz"))
    turned = _product(_product(own.rotation, ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))), _transposed(own.rotation))
    x, y, z = own.shift
    steiner = ((y * y + z * z, -x * y, -x * z), (-x * y, x * x + z * z, -y * z), (-x * z, -y * z, x * x + y * y))
    rows = [_sum(row, _times(mass, more)) for row, more in zip(turned, steiner, strict=True)]
    return Bulk(mass, _times(mass, own.shift), (rows[0], rows[1], rows[2]))


def _axis(joint: Joint, frame: Frame) -> Vector:
    axis = _vector(joint.axis.text if joint.axis else None, (1.0, 0.0, 0.0))
    length = math.sqrt(_dot(axis, axis))
    return _turned(frame.rotation, _times(1 / length, axis)) if length else (1.0, 0.0, 0.0)


def _radius(link: Link | None) -> float | None:
    """The radius of the largest cylinder or sphere of a link, of its collision first, in m."""
    for role in ("collision", "visual"):
        shapes = [each.shape for each in (link.geometries if link else ()) if each.role == role and each.shape]
        found = [_number(shape.attributes.get("radius")) for shape in shapes if shape.name in ("cylinder", "sphere")]
        known = [radius for radius in found if radius]
        if known:
            return max(known)
    return None


def _origin(tag: Tag | None) -> tuple[Vector, Vector]:
    attributes = tag.attributes if tag else {}
    return _vector(attributes.get("xyz"), _ZERO), _vector(attributes.get("rpy"), _ZERO)


def _vector(text: str | None, otherwise: Vector) -> Vector:
    numbers = [_number(part) for part in (text or "").split()]
    if len(numbers) != 3 or None in numbers:  # noqa: PLR2004
        return otherwise
    x, y, z = (number or 0.0 for number in numbers)
    return x, y, z


def _number(text: str | None) -> float | None:
    try:
        value = float(text or "")
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def _rotation(rpy: Vector) -> Matrix:
    (sr, sp, sy), (cr, cp, cy) = map(math.sin, rpy), map(math.cos, rpy)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def _transposed(matrix: Matrix) -> Matrix:
    first, second, third = zip(*matrix, strict=True)
    return first, second, third


def _product(left: Matrix, right: Matrix) -> Matrix:
    columns = _transposed(right)
    rows = [_turned(columns, row) for row in left]
    return rows[0], rows[1], rows[2]


def _turned(matrix: Matrix, vector: Vector) -> Vector:
    return _dot(matrix[0], vector), _dot(matrix[1], vector), _dot(matrix[2], vector)


def _dot(left: Sequence[float], right: Sequence[float]) -> float:
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2]


def _cross(left: Vector, right: Vector) -> Vector:
    (a, b, c), (x, y, z) = left, right
    return b * z - c * y, c * x - a * z, a * y - b * x


def _sum(left: Vector, right: Vector) -> Vector:
    return left[0] + right[0], left[1] + right[1], left[2] + right[2]


def _times(factor: float, vector: Vector) -> Vector:
    return factor * vector[0], factor * vector[1], factor * vector[2]
