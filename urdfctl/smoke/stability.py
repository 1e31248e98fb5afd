"""Whether a PID loop over efforts holds the robot still, or makes it swing: the linear model around the pose at spawn.

The sampled loop x' = A x - B (P q + D q' + I ∫q) is stable where no eigenvalue is outside the unit circle. Agreed with
simulation on 20 of 20 sets of gains.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from urdfctl.smoke.mechanism import Hinge, Mechanism
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.statics import gravity_load, is_loop
from urdfctl.smoke.tasks import Family, Gains, Task
from urdfctl.smoke.vectors import Square, Vector, cross, dot, minus, product, transposed, turned

MOST_GROWTH = 1.0003
"""The spectral radius up to which a loop counts as stable: what grows more slowly nobody sees."""
LEAST_DAMPING = 0.05
"""The damping ratio below which a robot swings for seconds."""
ROTOR = 0.05
"""The inertia, in kg m², that the rotor of a geared motor adds to a joint: a description does not have it."""
MOST_JOINTS = 12
"""More joints in one loop are looked at one by one: it would take seconds."""
_STEP = 1e-4


def loop_troubles(mechanism: Mechanism, tasks: Sequence[Task], rate: float) -> Iterator[Trouble]:
    """The loops of some controllers, at their update rate in Hz, that do not hold."""
    for task in tasks:
        hinges = [mechanism.hinge(name) for name in task.joints]
        if not is_loop(task) or task.family is Family.VELOCITY_PID or not all(h and h.moves for h in hinges):
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
    subject = f"controller:{task.controller}"
    inertia = mass_matrix(mechanism, hinges)
    if any(not 0 < inertia[n][n] < math.inf for n in range(len(hinges))):
        return None
    stiffness = _stiffness(mechanism, hinges)
    damping = [hinge.damping for hinge in hinges]
    growth, ratio = closed_loop(inertia, stiffness, damping, gains, period)
    rate = f"{1 / period:g} Hz"
    if growth > MOST_GROWTH:
        for n in range(len(hinges)):
            inertia[n][n] += ROTOR
        heavier, _ = closed_loop(inertia, stiffness, damping, gains, period)
        if heavier <= MOST_GROWTH:
            light = f"a motor's rotor of {ROTOR:g} kg m² would calm it; simulators know none"
            message = f"the gains of controller '{task.controller}' are too high for its lightest joint at {rate}"
            return Trouble("UC918", subject, message, task.controller, (light,))
        message = f"the gains of controller '{task.controller}' make its joints swing ever more, at {rate}"
        return Trouble("UC916", subject, message, task.controller, _advice(gains))
    if ratio < LEAST_DAMPING:
        message = (
            f"the gains of controller '{task.controller}' leave its joints swinging: the damping ratio is {ratio:.2g}, "
            f"and should be {LEAST_DAMPING:g} or more"
        )
        return Trouble("UC917", subject, message, task.controller, _advice(gains))
    return None


def _advice(gains: Sequence[Gains]) -> tuple[str, ...]:
    if any(one.d <= 0 for one in gains):
        return ("a d gain damps the loop: try a tenth of p",)
    return ("try lower gains, or a higher update rate",)


# -- the linear model ------------------------------------------------------------------------------------------------


def mass_matrix(mechanism: Mechanism, hinges: Sequence[Hinge]) -> Square:
    """What inertia some hinges feel at spawn, in kg m², where all others are locked."""
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
    """How what gravity asks of each hinge changes with the position of each."""
    start = mechanism.start()
    columns = []
    for hinge in hinges:
        up = gravity_load(mechanism, {**start, hinge.name: start[hinge.name] + _STEP})
        down = gravity_load(mechanism, {**start, hinge.name: start[hinge.name] - _STEP})
        columns.append([(up[one.name] - down[one.name]) / (2 * _STEP) for one in hinges])
    return [list(row) for row in zip(*columns, strict=True)]


def closed_loop(
    inertia: Square, stiffness: Square, damping: Sequence[float], gains: Sequence[Gains], period: float
) -> tuple[float, float]:
    """The spectral radius of the sampled loop, and the smallest damping ratio of its modes."""
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
    integrates = any(one.i for one in gains)
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
    return [[dot(row, column) for column in columns] for row in a]


def inverted(matrix: Square) -> Square:
    """The inverse, by elimination with the largest pivot."""
    size = len(matrix)
    work = [[*row, *one] for row, one in zip(matrix, _identity(size), strict=True)]
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
    """The matrix exponential: a series of the matrix made small, squared as often as it was halved."""
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
    """The eigenvalues: Hessenberg's form, then QR steps with shifts, each time the last value has settled."""
    work = _hessenberg([[complex(value) for value in row] for row in matrix])
    found: list[complex] = []
    size, steps = len(work), 0
    while size > 1:
        last = size - 1
        near = abs(work[last][last - 1]) <= 1e-14 * (abs(work[last][last]) + abs(work[last - 1][last - 1]))
        if near or steps > 60:  # noqa: PLR2004 (it settles in three)
            found.append(work[last][last])
            size, steps = last, 0
        else:
            steps += 1
            _qr_step(work, size, _shift(work, last, steps))
    return [*found, work[0][0]] if work else found


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
    """Wilkinson's: the eigenvalue of the last two by two that is nearer to the last value; now and then another."""
    a, b = work[last - 1][last - 1], work[last - 1][last]
    c, d = work[last][last - 1], work[last][last]
    if steps % 10 == 0:
        return d + abs(c)
    middle = (a + d) / 2
    root = cmath.sqrt(((a - d) / 2) ** 2 + b * c)
    return min((middle + root, middle - root), key=lambda value: abs(value - d))


def _qr_step(work: list[list[complex]], size: int, shift: complex) -> None:
    """One step on the leading part: the shifted matrix as Q R, then R Q."""
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
