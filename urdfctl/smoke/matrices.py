"""Small matrices without a library: product, inverse, exponential and eigenvalues."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

from urdfctl.model.geometry import Square, inner


def identity_matrix(size: int) -> Square:
    """Return the identity matrix of a size."""
    return [[float(n == m) for m in range(size)] for n in range(size)]


def matrix_product(a: Square, b: Square) -> Square:
    """Return the product of two matrices."""
    columns = list(zip(*b, strict=True))
    return [[inner(row, column) for column in columns] for row in a]


def inverted(matrix: Square) -> Square:
    """Return the inverse, by elimination with the largest pivot."""
    size = len(matrix)
    work = [[*row, *unit] for row, unit in zip(matrix, identity_matrix(size), strict=True)]
    for n in range(size):
        pivot = max(range(n, size), key=lambda row: abs(work[row][n]))
        work[n], work[pivot] = work[pivot], work[n]
        head = work[n][n] or 1e-300
        work[n] = [value / head for value in work[n]]
        for m in range(size):
            if m != n and work[m][n]:
                factor = work[m][n]
                work[m] = [value - factor * other for value, other in zip(work[m], work[n], strict=True)]
    return [row[size:] for row in work]


def exponential(matrix: Square) -> Square:
    """Return the matrix exponential: the series of the halved matrix, squared as often as the matrix was halved."""
    size = len(matrix)
    norm = max((sum(map(abs, row)) for row in matrix), default=0.0)
    halvings = max(0, math.ceil(math.log2(norm)) + 2) if 0 < norm < math.inf else 0
    small = [[value / 2**halvings for value in row] for row in matrix]
    term = total = identity_matrix(size)
    for n in range(1, 11):
        term = [[value / n for value in row] for row in matrix_product(term, small)]
        total = [[a + b for a, b in zip(row, other, strict=True)] for row, other in zip(total, term, strict=True)]
    for _ in range(halvings):
        total = matrix_product(total, total)
    return total


def eigenvalues(matrix: Sequence[Sequence[float]]) -> list[complex]:
    """Return the eigenvalues: Hessenberg form, then shifted QR steps until the last value has converged, one by one."""
    work = _hessenberg([[complex(value) for value in row] for row in matrix])
    values: list[complex] = []
    size, steps = len(work), 0
    while size > 1:
        last = size - 1
        near = abs(work[last][last - 1]) <= 1e-14 * (abs(work[last][last]) + abs(work[last - 1][last - 1]))
        if near or steps > 60:  # noqa: PLR2004 (three steps are usual)
            values.append(work[last][last])
            size, steps = last, 0
        else:
            steps += 1
            _qr_step(work, size, _shift(work, last, steps))
    return [*values, work[0][0]] if work else values


def _hessenberg(work: list[list[complex]]) -> list[list[complex]]:
    size = len(work)
    for k in range(size - 2):
        pivot = max(range(k + 1, size), key=lambda row: abs(work[row][k]))
        if not abs(work[pivot][k]):
            continue
        work[k + 1], work[pivot] = work[pivot], work[k + 1]
        for row in work:
            row[k + 1], row[pivot] = row[pivot], row[k + 1]
        for n in range(k + 2, size):
            factor = work[n][k] / work[k + 1][k]
            if factor:
                work[n] = [value - factor * other for value, other in zip(work[n], work[k + 1], strict=True)]
                for row in work:
                    row[k + 1] += factor * row[n]
    return work


def _shift(work: list[list[complex]], last: int, steps: int) -> complex:
    """Wilkinson's shift: the eigenvalue of the last 2 x 2 block that is nearer to the last value.
    Every tenth step uses another shift."""
    a, b = work[last - 1][last - 1], work[last - 1][last]
    c, d = work[last][last - 1], work[last][last]
    if steps % 10 == 0:
        return d + abs(c)
    middle = (a + d) / 2
    root = cmath.sqrt(((a - d) / 2) ** 2 + b * c)
    return min((middle + root, middle - root), key=lambda value: abs(value - d))


def _qr_step(work: list[list[complex]], size: int, shift: complex) -> None:
    """One step on the leading part: factor the shifted matrix into Q R, then multiply R Q."""
    for n in range(size):
        work[n][n] -= shift
    turns = []
    for k in range(size - 1):
        a, b = work[k][k], work[k + 1][k]
        length = math.hypot(abs(a), abs(b)) or 1e-300
        c, s = a / length, b / length
        turns.append((c, s))
        upper, lower = work[k], work[k + 1]
        for m in range(k, size):
            x, y = upper[m], lower[m]
            upper[m], lower[m] = c.conjugate() * x + s.conjugate() * y, c * y - s * x
    for k, (c, s) in enumerate(turns):
        for n in range(min(k + 2, size)):
            row = work[n]
            x, y = row[k], row[k + 1]
            row[k], row[k + 1] = x * c + y * s, y * c.conjugate() - x * s.conjugate()
    for n in range(size):
        work[n][n] += shift
