"""Inertia tensors: the six moments and the principal moments."""

from __future__ import annotations

import math
from collections.abc import Mapping

from urdfctl.model.robot import Inertial, Number
from urdfctl.rules.urdf.numbers import MOMENTS

Moments = tuple[float, float, float, float, float, float]


def moments_of(inertial: Inertial | None) -> Moments | None:
    """Return the six moments in kg m², as `ixx ixy ixz iyy iyz izz`; None if one cannot be read."""
    if inertial is None or inertial.inertia is None:
        return None
    values = [_value(inertial.inertia, name) for name in MOMENTS]
    ixx, ixy, ixz, iyy, iyz, izz = values
    if ixx is None or ixy is None or ixz is None or iyy is None or iyz is None or izz is None:
        return None
    return ixx, ixy, ixz, iyy, iyz, izz


def _value(inertia: Mapping[str, Number], name: str) -> float | None:
    number = inertia.get(name)
    value = number.value if number else None
    return value if value is not None and math.isfinite(value) else None


def principal_moments(moments: Moments) -> tuple[float, float, float]:
    """Return the eigenvalues of the tensor, smallest first."""
    ixx, ixy, ixz, iyy, iyz, izz = moments
    scale = max(abs(value) for value in moments)
    if scale == 0:
        return 0.0, 0.0, 0.0
    ixx, ixy, ixz, iyy, iyz, izz = (value / scale for value in moments)
    products = ixy**2 + ixz**2 + iyz**2
    if products == 0:
        least, middle, most = sorted((ixx, iyy, izz))
        return least * scale, middle * scale, most * scale
    mean = (ixx + iyy + izz) / 3
    a, b, c = ixx - mean, iyy - mean, izz - mean
    spread = math.sqrt((a**2 + b**2 + c**2 + 2 * products) / 6)
    determinant = a * b * c + 2 * ixy * ixz * iyz - a * iyz**2 - b * ixz**2 - c * ixy**2
    angle = math.acos(max(-1.0, min(1.0, determinant / (2 * spread**3)))) / 3
    most = mean + 2 * spread * math.cos(angle)
    least = mean + 2 * spread * math.cos(angle + 2 * math.pi / 3)
    return least * scale, (3 * mean - most - least) * scale, most * scale
