"""How joints affect each other's velocity: the inverse of the mass matrix in one pose."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping

from urdfctl.model.geometry import Square
from urdfctl.startup.records import NamedTuple

_SINGULAR = 1e-12
"""A pivot below this part of its diagonal element makes a matrix singular."""
_STEPS = 40
"""The number of steps of the power iteration."""
_SEED = 7


class Inverse(NamedTuple):
    """The inverse of a mass matrix, in 1/(kg m2), 1/(kg m) or 1/kg. `row_of` has the row of each joint, by name."""

    row_of: dict[str, int]
    rows: Square

    def alone(self, name: str) -> float | None:
        """Return the inertia of a joint while all others are free; None if it is not in the matrix."""
        row = self.row_of.get(name)
        return 1 / self.rows[row][row] if row is not None and self.rows[row][row] > 0 else None

    def greatest(self, inertias: Mapping[str, float]) -> float:
        """Return the greatest eigenvalue of the inverse times the diagonal matrix of the inertias, at least 1."""
        roots = [math.sqrt(max(0.0, inertias[name])) for name in self.row_of]
        scaled = [
            [value * one * other for value, other in zip(row, roots, strict=True)]
            for row, one in zip(self.rows, roots, strict=True)
        ]
        chance = random.Random(_SEED)  # noqa: S311 (the same start each time)
        vector, greatest = [chance.uniform(0.5, 1.0) * chance.choice((-1, 1)) for _ in roots], 0.0
        for _ in range(_STEPS):
            vector = [sum(map(float.__mul__, row, vector)) for row in scaled]
            greatest = math.hypot(*vector)
            if not greatest:
                break
            vector = [value / greatest for value in vector]
        return max(1.0, greatest)


def inverted(matrix: Square) -> Square | None:
    """Return the inverse of a symmetric positive definite matrix; None if it is singular."""
    size = len(matrix)
    work = [[*row, *(float(n == m) for m in range(size))] for n, row in enumerate(matrix)]
    for n in range(size):
        pivot = work[n][n]
        if pivot <= _SINGULAR * matrix[n][n]:
            return None
        work[n] = [value / pivot for value in work[n]]
        for m in range(size):
            if m != n and work[m][n]:
                factor = work[m][n]
                work[m] = [value - factor * other for value, other in zip(work[m], work[n], strict=True)]
    return [row[size:] for row in work]
