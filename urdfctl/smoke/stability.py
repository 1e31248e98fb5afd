"""The stability of PID loops that command efforts, from the linear model of the robot around its pose at spawn.

The sampled loop x' = A x - B (P q + D q' + I ∫q) is stable if no eigenvalue is outside the unit circle. The result
agreed with simulation for 20 of 20 sets of gains.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from urdfctl.model.geometry import Square, Vector, cross, dot, inner, minus, product, transposed, turned
from urdfctl.rules.smoke.loop_too_soft import loop_too_soft
from urdfctl.rules.smoke.loop_too_stiff_without_rotor import loop_too_stiff_without_rotor
from urdfctl.rules.smoke.loop_underdamped import loop_underdamped
from urdfctl.rules.smoke.loop_unstable import loop_unstable
from urdfctl.smoke.loads import gravity_load
from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.tasks import Family, Gains, Task, is_loop

MOST_GROWTH = 1.0003
"""The spectral radius up to which a loop counts as stable: slower growth is not visible."""
LEAST_DAMPING = 0.05
"""Below this damping ratio a robot swings for seconds."""
ROTOR = 0.05
"""The inertia that the rotor of a geared motor adds to a joint, in kg m². Robot descriptions do not contain it."""
MOST_SAG, SAG_TIME = 0.1, 2.0
"""A joint may sag by this fraction of its range; the integral part has this time to make up for it, in s."""
MOST_JOINTS = 12
"""With more joints than this in one loop, each joint is checked alone: together they would take seconds."""
_STEP = 1e-4


def loop_troubles(mechanism: Mechanism, tasks: Sequence[Task], rate: float) -> Iterator[Trouble]:
    """Yield the control loops that are not stable or not damped, at an update rate in Hz."""
    for task in tasks:
        hinges = [mechanism.hinge(name) for name in task.joints]
        if (
            not is_loop(task)
            or task.through
            or task.family is Family.VELOCITY_PID
            or not all(h and h.moves for h in hinges)
        ):
            continue
        known = [hinge for hinge in hinges if hinge]
        groups = [range(len(known))] if len(known) <= MOST_JOINTS else [range(n, n + 1) for n in range(len(known))]
        for group in groups:
            chosen = [known[n] for n in group]
            trouble = _judged(mechanism, chosen, [task.gains[n] for n in group], 1 / rate, task)
            if trouble:
                yield trouble
                break


def _judged(mechanism: Mechanism, hinges: list[Hinge], gains: list[Gains], period: float, task: Task) -> Trouble | None:
    subject, controller = f"controller:{task.controller}", task.controller
    inertia = mass_matrix(mechanism, hinges)
    if any(not 0 < inertia[n][n] < math.inf for n in range(len(hinges))):
        return None
    stiffness = _stiffness(mechanism, hinges)
    damping = [hinge.damping for hinge in hinges]
    growth, ratio = closed_loop(inertia, stiffness, damping, gains, period)
    if growth > MOST_GROWTH:
        for n in range(len(hinges)):
            inertia[n][n] += ROTOR
        growth_with_rotors, _ = closed_loop(inertia, stiffness, damping, gains, period)
        if growth_with_rotors <= MOST_GROWTH:
            note = f"a motor's rotor of {ROTOR:g} kg m² would steady the joint; simulators do not model rotors"
            return trouble_of(loop_too_stiff_without_rotor, subject, controller, (note,), rate=1 / period)
        return trouble_of(loop_unstable, subject, controller, _advice(gains), rate=1 / period)
    if ratio < LEAST_DAMPING:
        return trouble_of(loop_underdamped, subject, controller, _advice(gains), ratio=ratio, least=LEAST_DAMPING)
    return _sagging(mechanism, hinges, gains, task)


def _sagging(mechanism: Mechanism, hinges: Sequence[Hinge], gains: Sequence[Gains], task: Task) -> Trouble | None:
    """The joint that sags most under its weight at spawn, if that is much of its range."""
    load = gravity_load(mechanism, mechanism.start())
    for hinge, gain in zip(hinges, gains, strict=True):
        weight = abs(load.get(hinge.name, 0.0))
        stiffness = gain.p + gain.i * SAG_TIME
        sag = max(weight / stiffness, (weight - gain.clamp) / gain.p) if gain.p > 0 and stiffness > 0 else 0.0
        low, high = hinge.span
        if sag > MOST_SAG * (high - low):
            fields = {
                "joint": hinge.name,
                "sag": sag,
                "unit": hinge.unit,
                "weight": weight,
                "effort": hinge.effort_unit,
            }
            return trouble_of(loop_too_soft, f"controller:{task.controller}", task.controller, (), **fields)
    return None


def _advice(gains: Sequence[Gains]) -> tuple[str, ...]:
    if any(gain.d <= 0 for gain in gains):
        return ("a d gain damps the loop: try a tenth of the p gain",)
    return ("lower the gains, or raise the update rate",)


# -- the linear model ------------------------------------------------------------------------------------------------


def mass_matrix(mechanism: Mechanism, hinges: Sequence[Hinge]) -> Square:
    """Return the inertia that some hinges move at spawn, in kg m² (kg if they slide), while all others are locked."""
    poses = mechanism.poses(mechanism.start())
    size = len(hinges)
    matrix = [[0.0] * size for _ in range(size)]
    axes = [turned(poses[hinge.child].turn, hinge.axis) for hinge in hinges]
    below = [mechanism.below(hinge.child) for hinge in hinges]
    for name, body in mechanism.bodies.items():
        moved = [n for n in range(size) if name in below[n]]
        if not moved or not body.mass:
            continue
        place, turn = poses[name].at(body.centre), poses[name].turn
        inertia = product(product(turn, body.inertia), transposed(turn))
        ways = {}
        for n in moved:
            straight = hinges[n].type == "prismatic"
            lever: Vector = axes[n] if straight else cross(axes[n], minus(place, poses[hinges[n].child].place))
            ways[n] = lever, None if straight else axes[n]
        for n in moved:
            for m in moved:
                (lever, axis), (other_lever, other_axis) = ways[n], ways[m]
                matrix[n][m] += body.mass * dot(lever, other_lever)
                if axis and other_axis:
                    matrix[n][m] += dot(axis, turned(inertia, other_axis))
    return matrix


def _stiffness(mechanism: Mechanism, hinges: Sequence[Hinge]) -> Square:
    """How the load of gravity on each hinge changes with the position of each hinge."""
    start = mechanism.start()
    columns = []
    for hinge in hinges:
        up = gravity_load(mechanism, {**start, hinge.name: start[hinge.name] + _STEP})
        down = gravity_load(mechanism, {**start, hinge.name: start[hinge.name] - _STEP})
        columns.append([(up[row.name] - down[row.name]) / (2 * _STEP) for row in hinges])
    return [list(row) for row in zip(*columns, strict=True)]


def closed_loop(
    inertia: Square, stiffness: Square, damping: Sequence[float], gains: Sequence[Gains], period: float
) -> tuple[float, float]:
    """Return the spectral radius of the sampled loop, and the smallest damping ratio of its modes."""
    size = len(gains)
    inverse = inverted(inertia)
    free = [[-value for value in row] for row in _times(inverse, stiffness)]
    slowed = [[-inverse[n][m] * damping[m] for m in range(size)] for n in range(size)]
    none = [[0.0] * size for _ in range(size)]
    whole = [
        *([*none[n], *_identity(size)[n], *none[n]] for n in range(size)),
        *([*free[n], *slowed[n], *inverse[n]] for n in range(size)),
        *([0.0] * (3 * size) for _ in range(size)),
    ]
    sampled = exponential([[value * period for value in row] for row in whole])
    states = 2 * size
    integrates = any(gain.i for gain in gains)
    matrix = []
    for n in range(states):
        pushes = sampled[n][states:]
        row = [
            sampled[n][m] - pushes[m % size] * (gains[m % size].p if m < size else gains[m % size].d)
            for m in range(states)
        ]
        matrix.append(row + ([-pushes[m] * gains[m].i for m in range(size)] if integrates else []))
    sums = [[*(period if m == n else 0.0 for m in range(states)), *_identity(size)[n]] for n in range(size)]
    matrix += sums if integrates else []
    if not all(math.isfinite(value) for row in matrix for value in row):
        return math.inf, -1.0
    values = eigenvalues(matrix)
    rates = [cmath.log(value) / period for value in values if abs(value) > 1e-300]  # noqa: PLR2004 (zero in floats)
    ratios = [-rate.real / abs(rate) for rate in rates if abs(rate) > 1e-9]  # noqa: PLR2004
    return max(map(abs, values), default=0.0), min(ratios, default=1.0)


# -- small matrices --------------------------------------------------------------------------------------------------


def _identity(size: int) -> Square:
    return [[float(n == m) for m in range(size)] for n in range(size)]


def _times(a: Square, b: Square) -> Square:
    columns = list(zip(*b, strict=True))
    return [[inner(row, column) for column in columns] for row in a]


def inverted(matrix: Square) -> Square:
    """Return the inverse, by elimination with the largest pivot."""
    size = len(matrix)
    work = [[*row, *unit] for row, unit in zip(matrix, _identity(size), strict=True)]
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
    term = total = _identity(size)
    for n in range(1, 11):
        term = [[value / n for value in row] for row in _times(term, small)]
        total = [[a + b for a, b in zip(row, other, strict=True)] for row, other in zip(total, term, strict=True)]
    for _ in range(halvings):
        total = _times(total, total)
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
