"""The nearest inertia that a body can have, in place of an impossible one in the text of a robot."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

from urdfctl.startup.records import NamedTuple

_TAG = re.compile(r"<inertia\b[^<>]*>")
_MASS = re.compile(r"<mass\b[^<>]*\bvalue\s*=\s*[\"']([^\"']*)[\"']")
_LINK = re.compile(r"<link\b[^<>]*\bname\s*=\s*[\"']([^\"']*)[\"']")
_NAMES = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_LEAST, _SLIM = 1e-9, 1e-3
"""The least principal moment, in kg m² and as a part of the greatest one."""
_REACH = 0.01
"""The radius of gyration of a body whose moments are all 0, in m."""
_SLACK = 1e-3
"""By about this part the sum of two moments exceeds the third one: rounding must not undo the repair."""
_SAME = 1e-9
"""A sum of two moments that is less than the third one by this part is equal to it."""


class RepairedText(NamedTuple):
    """A repaired text, and what was changed, a line for each link."""

    text: str
    changes: tuple[str, ...]


def with_valid_inertia(text: str) -> RepairedText:
    """Return the text of a robot in which each impossible inertia that is given in numbers is the nearest valid one."""
    changes: list[str] = []

    def repaired(found: re.Match[str]) -> str:
        tag = found[0]
        values = [_number(tag, name) for name in _NAMES]
        mass = max(_values(_MASS, text[_start(text, found) : found.end() + 200]), default=0.0)
        if any(value is None for value in values) or mass <= 0:
            return tag
        given = [value or 0.0 for value in values]
        valid = nearest_valid(given, mass)
        if valid is None:
            return tag
        names = _LINK.findall(text[: found.start()])
        shown = ", ".join(f"{name} {value:.4g}" for name, value in zip(_NAMES, valid, strict=True) if value)
        changes.append(f"inertia of link '{names[-1] if names else ''}': {shown}")
        for name, value in zip(_NAMES, valid, strict=True):
            tag = re.sub(rf"(\b{name}\s*=\s*)([\"'])[^\"']*\2", rf"\g<1>\g<2>{value:.6g}\g<2>", tag)
        return tag

    return RepairedText(_TAG.sub(repaired, text), tuple(changes))


def _start(text: str, found: re.Match[str]) -> int:
    """The beginning of the `<inertial>` around a tag."""
    return max(text.rfind("<inertial", 0, found.start()), 0)


def _values(pattern: re.Pattern[str], text: str) -> list[float]:
    return [
        number for word in pattern.findall(text.partition("</inertial>")[0]) if (number := _float(word)) is not None
    ]


def _number(tag: str, name: str) -> float | None:
    given = re.search(rf"\b{name}\s*=\s*[\"']([^\"']*)[\"']", tag)
    return _float(given[1]) if given else 0.0


def _float(word: str) -> float | None:
    try:
        value = float(word)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def nearest_valid(given: Sequence[float], mass: float, slack: float = _SLACK) -> list[float] | None:
    """Return the moments of a body nearest to the given ones, in their order; None if the given ones are valid.

    The principal axes are kept. A negative principal moment becomes a small one. The greatest one and the two others
    meet where it is their sum, which is the nearest place.

    slack: the part by which the sum of two moments exceeds the third one in the result. If it is smaller than usual, so
        must the given ones.
    """
    xx, xy, xz, yy, yz, zz = given
    moments, axes = _principal([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    greatest = max(moments)
    least = max(_LEAST, _SLIM * greatest) if greatest > 0 else mass * _REACH**2
    if min(moments) > 0 and 2 * greatest <= sum(moments) * (1 + (_SAME if slack == _SLACK else -slack)):
        return None
    moments = [max(moment, least) for moment in moments]
    top = moments.index(max(moments))
    excess = 2 * moments[top] - sum(moments)
    if excess >= (0 if slack == _SLACK else -slack * sum(moments)):
        others = [moment + excess / 3 for moment in moments]
        others[top] = (sum(others) - others[top]) / (1 + slack)
        moments = others
    whole = [[sum(moments[k] * axes[n][k] * axes[m][k] for k in range(3)) for m in range(3)] for n in range(3)]
    return [whole[0][0], whole[0][1], whole[0][2], whole[1][1], whole[1][2], whole[2][2]]


def _principal(matrix: list[list[float]]) -> tuple[list[float], list[list[float]]]:
    """The principal moments and, in columns, the axes of a symmetric matrix, by Jacobi's rotations."""
    axes = [[float(n == m) for m in range(3)] for n in range(3)]
    for _ in range(30):
        n, m = max(((0, 1), (0, 2), (1, 2)), key=lambda place: abs(matrix[place[0]][place[1]]))
        if abs(matrix[n][m]) < 1e-15 * max(1e-300, *(abs(matrix[k][k]) for k in range(3))):
            break
        angle = 0.5 * math.atan2(2 * matrix[n][m], matrix[m][m] - matrix[n][n])
        c, s = math.cos(angle), math.sin(angle)
        turn = [[float(i == j) for j in range(3)] for i in range(3)]
        turn[n][n], turn[m][m], turn[n][m], turn[m][n] = c, c, s, -s
        matrix = _times(_flipped(turn), _times(matrix, turn))
        axes = _times(axes, turn)
    return [matrix[k][k] for k in range(3)], axes


def _times(a: list[list[float]], b: list[list[float]]) -> list[list[float]]:
    return [[sum(a[n][k] * b[k][m] for k in range(3)) for m in range(3)] for n in range(3)]


def _flipped(a: list[list[float]]) -> list[list[float]]:
    return [list(row) for row in zip(*a, strict=True)]
