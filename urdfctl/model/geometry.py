"""Vectors, rotations and small matrices as tuples and lists, for kinematics without numpy."""

from __future__ import annotations

import math
from collections.abc import Sequence

from urdfctl.startup.records import NamedTuple

Vector = tuple[float, float, float]
Rotation = tuple[Vector, Vector, Vector]
Square = list[list[float]]

ZERO: Vector = (0.0, 0.0, 0.0)
UPRIGHT: Rotation = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Pose(NamedTuple):
    """The place of a frame in another one, in m, and its rotation there."""

    place: Vector = ZERO
    turn: Rotation = UPRIGHT

    def then(self, other: Pose) -> Pose:
        """Return a pose given in this frame, in the outer frame."""
        return Pose(self.at(other.place), product(self.turn, other.turn))

    def at(self, point: Vector) -> Vector:
        """Return a point given in this frame, in the outer frame."""
        return plus(self.place, turned(self.turn, point))


def plus(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def minus(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scaled(a: Vector, factor: float) -> Vector:
    """Return a multiple of a."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    """Return the scalar product of two vectors of three parts."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def inner(a: Sequence[float], b: Sequence[float]) -> float:
    """Return the scalar product of two rows of any length."""
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a: Vector) -> Vector:
    """Return the direction of a with length 1, or a itself if its length is 0."""
    length = math.sqrt(dot(a, a))
    return scaled(a, 1 / length) if length > 0 else a


def turned(turn: Rotation, a: Vector) -> Vector:
    """Return a vector after a rotation."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = turn
    x, y, z = a
    return xx * x + xy * y + xz * z, yx * x + yy * y + yz * z, zx * x + zy * y + zz * z


def product(a: Rotation, b: Rotation) -> Rotation:
    """Return the rotation that applies b, then a."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = b
    first, second, third = (
        (x * xx + y * yx + z * zx, x * xy + y * yy + z * zy, x * xz + y * yz + z * zz) for x, y, z in a
    )
    return first, second, third


def transposed(a: Rotation) -> Rotation:
    """Return the inverse of a rotation."""
    return tuple(zip(*a, strict=True))  # type: ignore[return-value]


def of_angles(roll: float, pitch: float, yaw: float) -> Rotation:
    """Return the rotation of URDF's rpy: about the fixed axes x, y and z in this order, in rad."""
    (cr, sr), (cp, sp), (cy, sy) = ((math.cos(angle), math.sin(angle)) for angle in (roll, pitch, yaw))
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def about(axis: Vector, angle: float) -> Rotation:
    """Return the rotation about an axis of length 1, by an angle in rad."""
    (x, y, z), c, s = axis, math.cos(angle), math.sin(angle)
    d = 1 - c
    return (
        (c + x * x * d, x * y * d - z * s, x * z * d + y * s),
        (y * x * d + z * s, c + y * y * d, y * z * d - x * s),
        (z * x * d - y * s, z * y * d + x * s, c + z * z * d),
    )
