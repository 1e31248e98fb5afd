"""The stability of PID loops that command efforts, from the linear model of the robot around its pose at spawn.

The sampled loop x' = A x - B (P q + D q' + I ∫q) is stable if no eigenvalue is outside the unit circle. The result
agreed with simulation for 20 of 20 sets of gains.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from urdfctl.model.geometry import Square, Vector, cross, dot, minus, product, transposed, turned
from urdfctl.rules.smoke.loop_too_soft import loop_too_soft
from urdfctl.rules.smoke.loop_too_stiff_without_rotor import loop_too_stiff_without_rotor
from urdfctl.rules.smoke.loop_underdamped import loop_underdamped
from urdfctl.rules.smoke.loop_unstable import loop_unstable
from urdfctl.rules.smoke.loop_without_gain import loop_without_gain
from urdfctl.smoke.matrices import eigenvalues, exponential, identity_matrix, inverted, matrix_product
from urdfctl.smoke.results import Trouble, trouble_of
from urdfctl.smoke.robot import Hinge, Mechanism, gravity_load, is_wheel, wheels_of
from urdfctl.smoke.statics.loops.gain_faults import GainFault, gain_fault
from urdfctl.smoke.tasks import ControllerTask, MotionFamily, PidGains

MOST_GROWTH = 1.0003
"""The spectral radius up to which a loop counts as stable: slower growth is not visible."""
LEAST_DAMPING = 0.05
"""Below this damping ratio a robot swings for seconds."""
FAST_DECAY = 12.0
"""What decays at this rate, in 1/s, is over in a quarter of a second, however often it swings."""
GOOD_DAMPING = 0.7
"""The damping ratio with which a joint settles soonest."""
ROTOR = 0.05
"""The inertia that the rotor of a geared motor adds to a joint, in kg m². Robot descriptions do not contain it."""
MOST_SAG, SAG_TIME = 0.1, 2.0
"""A joint may sag by this fraction of its range; the integral part has this time to make up for it, in s."""
MOST_JOINTS = 12
"""With more joints than this in one loop, each joint is checked alone: together they would take seconds."""
_STEP = 1e-4

Model = tuple[Square, Square, Sequence[float]]
"""The inertia that some joints move, their stiffness and their damping."""


def loop_troubles(mechanism: Mechanism, tasks: Sequence[ControllerTask], rate: float) -> Iterator[Trouble]:
    """Yield the control loops that are not stable or not damped, at an update rate in Hz."""
    for task in tasks:
        hinges = [mechanism.hinge(name) for name in task.joints]
        if not task.is_loop or task.through or not all(h and h.moves for h in hinges):
            continue
        known = [hinge for hinge in hinges if hinge]
        idle = _without_gain(task, known)
        if idle:
            yield idle
            continue
        groups = [range(len(known))] if len(known) <= MOST_JOINTS else [range(n, n + 1) for n in range(len(known))]
        for group in groups:
            chosen = [known[n] for n in group]
            trouble = _judged(mechanism, chosen, [task.gains[n] for n in group], 1 / rate, task)
            if trouble:
                yield trouble
                break


def _judged(
    mechanism: Mechanism, hinges: list[Hinge], gains: list[PidGains], period: float, task: ControllerTask
) -> Trouble | None:
    holds_speed = task.family is MotionFamily.VELOCITY_PID
    if holds_speed:
        gains = [_of_speed(gain) for gain in gains]
    inertia = mass_matrix(mechanism, hinges)
    if holds_speed:
        for n, carried in enumerate(_carried(mechanism, hinges)):
            inertia[n][n] += carried
    if any(not 0 < inertia[n][n] < math.inf for n in range(len(hinges))):
        return None
    stiffness = [[0.0] * len(hinges) for _ in hinges] if holds_speed else _stiffness(mechanism, hinges)
    damping = [hinge.damping for hinge in hinges]
    growth, ratio = closed_loop(inertia, stiffness, damping, gains, period)
    if growth > MOST_GROWTH or (ratio < 0 and any(min(gain.p, gain.i, gain.d) < 0 for gain in gains)):
        heavier = [[each + ROTOR * (n == m) for m, each in enumerate(row)] for n, row in enumerate(inertia)]
        growth_with_rotors, _ = closed_loop(heavier, stiffness, damping, gains, period)
        if growth > MOST_GROWTH >= growth_with_rotors:
            return _too_stiff(hinges, gains, (inertia, stiffness, damping), period, task)
        return _unstable(hinges, gains, (inertia, stiffness, damping), period, task)
    if holds_speed:
        return None
    if ratio < LEAST_DAMPING:
        return _underdamped(hinges, gains, (inertia, stiffness, damping), period, task, ratio=ratio)
    return _sagging(mechanism, hinges, gains, task)


def needs_grip(mechanism: Mechanism, task: ControllerTask, rate: float) -> bool:
    """Return whether a loop of wheels is stable only while they grip the ground: not in the air, as engines hold it."""
    if task.family is not MotionFamily.VELOCITY_PID or not task.is_loop or task.through:
        return False
    hinges = [hinge for name in task.joints if (hinge := mechanism.hinge(name)) and hinge.moves]
    if len(hinges) != len(task.gains) or not any(_carried(mechanism, hinges)):
        return False
    inertia = mass_matrix(mechanism, hinges)
    for n, (hinge, gain) in enumerate(zip(hinges, task.gains, strict=True)):
        if 0 < inertia[n][n] < math.inf:
            growth, _ = closed_loop([[inertia[n][n]]], [[0.0]], [hinge.damping], [_of_speed(gain)], 1 / rate)
            if growth > MOST_GROWTH:
                return True
    return False


def _carried(mechanism: Mechanism, hinges: Sequence[Hinge]) -> list[float]:
    """The inertia that each hinge moves besides its link, in kg m²: a wheel that grips moves its share of the robot."""
    everyone = [] if mechanism.is_fixed else wheels_of(mechanism, [hinge.name for hinge in mechanism.hinges], "")
    radii = {
        wheel.hinge.name: mechanism.bodies[wheel.hinge.child].radius or 0.0
        for wheel in everyone
        if is_wheel(mechanism, wheel)
    }
    share = sum(body.mass for body in mechanism.bodies.values()) / max(1, len(radii))
    return [share * radii.get(hinge.name, 0.0) ** 2 for hinge in hinges]


def _without_gain(task: ControllerTask, hinges: Sequence[Hinge]) -> Trouble | None:
    """The finding that a joint has no gain at all, or None."""
    for hinge, gain in zip(hinges, task.gains, strict=True):
        if not gain.p and not gain.i and not gain.feed:
            at = f"gain:{task.controller}/{gain.prefix}p"
            return trouble_of(loop_without_gain, at, task.controller, (), joint=hinge.name)
    return None


def _of_speed(gain: PidGains) -> PidGains:
    """The gains of a loop that holds a velocity, as gains on the position: it is the integral of the velocity."""
    return gain._replace(p=gain.i, i=0.0, d=gain.p)


def _fault_of_joint(
    hinges: Sequence[Hinge], gains: Sequence[PidGains], model: Model, period: float
) -> tuple[int, GainFault] | None:
    """The first joint that is unstable by itself, and its gain that makes it so."""
    inertia, stiffness, damping = model
    for n, (hinge, gain) in enumerate(zip(hinges, gains, strict=True)):

        def is_stable(tried: PidGains, n: int = n) -> bool:
            growth, _ = closed_loop([[inertia[n][n]]], [[stiffness[n][n]]], [damping[n]], [tried], period)
            return growth <= MOST_GROWTH

        fault = gain_fault(hinge, gain, inertia[n][n], 1 / period, is_stable)
        if fault:
            return n, fault
    return None


def _too_stiff(
    hinges: Sequence[Hinge], gains: Sequence[PidGains], model: Model, period: float, task: ControllerTask
) -> Trouble:
    """The finding that a loop is unstable only without rotors, with the joint that is so by itself."""
    found, subject = _fault_of_joint(hinges, gains, model, period), f"controller:{task.controller}"
    notes = [f"a motor's rotor of {ROTOR:g} kg m² would steady the joint; simulators do not model rotors"]
    which = "its lightest joint"
    if found:
        n, fault = found
        which = f"joint '{hinges[n].name}'"
        notes.insert(0, fault.why)
    return trouble_of(
        loop_too_stiff_without_rotor, subject, task.controller, tuple(notes), rate=1 / period, which=which
    )


def _unstable(
    hinges: Sequence[Hinge], gains: Sequence[PidGains], model: Model, period: float, task: ControllerTask
) -> Trouble:
    """The finding that a loop is unstable, with the gain of the joint that is so by itself."""
    found = _fault_of_joint(hinges, gains, model, period)
    if found:
        n, fault = found
        names = {"p": "i", "d": "p"} if task.family is MotionFamily.VELOCITY_PID else {}
        name = names.get(fault.gain, fault.gain)
        why = name + fault.why.removeprefix(fault.gain)
        at = f"gain:{task.controller}/{gains[n].prefix}{name}"
        return trouble_of(loop_unstable, at, task.controller, (), rate=1 / period, why=why)
    why, advice = "its joints swing more and more", _advice(gains)
    return trouble_of(loop_unstable, f"controller:{task.controller}", task.controller, advice, rate=1 / period, why=why)


def _underdamped(
    hinges: Sequence[Hinge],
    gains: Sequence[PidGains],
    model: Model,
    period: float,
    task: ControllerTask,
    *,
    ratio: float,
) -> Trouble:
    """The finding that a loop swings for long, with the joint that swings most by itself and a d that damps it."""
    inertia, stiffness, damping = model

    def alone(n: int, gain: PidGains) -> float:
        return closed_loop([[inertia[n][n]]], [[stiffness[n][n]]], [damping[n]], [gain], period)[1]

    ratios = [alone(n, gain) for n, gain in enumerate(gains)]
    worst = min(range(len(hinges)), key=ratios.__getitem__)
    if ratios[worst] >= LEAST_DAMPING:
        subject, notes, which = f"controller:{task.controller}", _advice(gains), "its joints"
    else:
        gain, hinge, ratio, moved = gains[worst], hinges[worst], ratios[worst], inertia[worst][worst]
        subject, which = f"gain:{task.controller}/{gain.prefix}d", f"joint '{hinge.name}'"
        wanted = 2 * GOOD_DAMPING * math.sqrt(max(0.0, gain.p) * moved) - damping[worst]
        steadies = wanted > gain.d and alone(worst, gain._replace(d=wanted)) >= LEAST_DAMPING
        load = f"{moved:.2g} {'kg' if hinge.type == 'prismatic' else 'kg m²'}"
        notes = (f"with the {load} that it moves, a d of {wanted:.2g} damps it",) if steadies else _advice(gains)
    fields = {"which": which, "ratio": ratio, "least": LEAST_DAMPING}
    return trouble_of(loop_underdamped, subject, task.controller, notes, **fields)


def _sagging(
    mechanism: Mechanism, hinges: Sequence[Hinge], gains: Sequence[PidGains], task: ControllerTask
) -> Trouble | None:
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


def _advice(gains: Sequence[PidGains]) -> tuple[str, ...]:
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
    inertia: Square, stiffness: Square, damping: Sequence[float], gains: Sequence[PidGains], period: float
) -> tuple[float, float]:
    """Return the spectral radius of the sampled loop, and the smallest damping ratio of its modes that last."""
    size = len(gains)
    inverse = inverted(inertia)
    free = [[-value for value in row] for row in matrix_product(inverse, stiffness)]
    slowed = [[-inverse[n][m] * damping[m] for m in range(size)] for n in range(size)]
    none = [[0.0] * size for _ in range(size)]
    whole = [
        *([*none[n], *identity_matrix(size)[n], *none[n]] for n in range(size)),
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
    sums = [[*(period if m == n else 0.0 for m in range(states)), *identity_matrix(size)[n]] for n in range(size)]
    matrix += sums if integrates else []
    if not all(math.isfinite(value) for row in matrix for value in row):
        return math.inf, -1.0
    values = eigenvalues(matrix)
    rates = [cmath.log(value) / period for value in values if abs(value) > 1e-300]  # noqa: PLR2004 (zero in floats)
    ratios = [-rate.real / abs(rate) for rate in rates if abs(rate) > 1e-9 and -rate.real < FAST_DECAY]  # noqa: PLR2004
    return max(map(abs, values), default=0.0), min(ratios, default=1.0)
