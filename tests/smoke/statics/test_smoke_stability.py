"""Control loops: the linear model agrees with the same loops simulated step by step; its limits are where they say."""

from __future__ import annotations

import math
import random

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.matrices import eigenvalues, exponential
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.loops import stability
from urdfctl.smoke.statics.loops.stability import closed_loop, loop_troubles
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily, PidGains

UP = (0.0, 0.0, 1.0)


def simulated_growth(inertia: float, damping: float, gains: PidGains, period: float) -> float:
    """The growth of a loop's motion in a period, from the motion itself: integrated in small steps between updates.

    The position starts at 1 rad, the target is 0. The motion is scaled back when it becomes large or small.
    """
    position, speed, total = 1.0, 0.0, 0.0
    updates, small, steps = 3000, period / 200, 200
    logarithm, at_half = 0.0, 0.0
    for update in range(updates):
        push = -gains.p * position - gains.d * speed + total
        total += -gains.i * position * period
        for _ in range(steps):
            half = speed + (push - damping * speed) / inertia * small / 2  # the midpoint rule
            speed += (push - damping * half) / inertia * small
            position += half * small
        size = math.sqrt(position**2 + (speed * period) ** 2 + (total / max(gains.p, 1.0)) ** 2)
        position, speed, total, logarithm = position / size, speed / size, total / size, logarithm + math.log(size)
        if update == updates // 2:
            at_half = logarithm
    return math.exp((logarithm - at_half) / (updates - updates // 2 - 1))


@pytest.mark.parametrize("seed", range(8))
def test_a_loop_grows_as_fast_as_its_simulation(seed: int) -> None:
    chance = random.Random(seed)  # noqa: S311 (a sample)
    inertia, period = chance.uniform(0.1, 2.0), chance.choice([0.001, 0.01])
    fastest = inertia / period**2
    gains = PidGains(p=fastest * 10 ** chance.uniform(-3, 0), d=fastest * period * 10 ** chance.uniform(-2, 0.5))
    damping = chance.choice([0.0, inertia / period / 50])
    growth, _ = closed_loop([[inertia]], [[0.0]], [damping], [gains], period)
    assert simulated_growth(inertia, damping, gains, period) == pytest.approx(growth, rel=2e-3)


def test_a_loop_with_an_integral_part_grows_as_fast_as_its_simulation() -> None:
    gains = PidGains(p=200.0, i=4000.0, d=10.0)
    growth, _ = closed_loop([[1.0]], [[0.0]], [0.0], [gains], 0.01)
    assert growth > 1.0
    assert simulated_growth(1.0, 0.0, gains, 0.01) == pytest.approx(growth, rel=2e-3)


@pytest.mark.parametrize(("d", "expected"), [(0.1, 0.05), (0.6, 0.3)])
def test_the_damping_ratio_is_that_of_the_textbook(d: float, expected: float) -> None:
    """A mass of 1 kg m² on a gain of 1 N m/rad: the ratio is d / 2 if the updates are much faster than the motion."""
    assert closed_loop([[1.0]], [[0.0]], [0.0], [PidGains(p=1.0, d=d)], 0.001)[1] == pytest.approx(expected, rel=0.01)


# -- limits ------------------------------------------------------------------------------------------------------------


def turning(inertia: float, joints: int = 1) -> Mechanism:
    """Return some joints side by side, each of which turns an inertia about a vertical axis."""
    square = ((inertia, 0.0, 0.0), (0.0, inertia, 0.0), (0.0, 0.0, inertia))
    hinges = [
        Hinge(f"j{n}", "revolute", parent="base", child=f"l{n}", pose=Pose(), axis=UP)._replace(lower=-1.0, upper=1.0)
        for n in range(joints)
    ]
    bodies = {f"l{n}": LinkBody(f"l{n}", 0.1, inertia=square) for n in range(joints)}
    return Mechanism("base", {"base": LinkBody("base"), **bodies}, tuple(hinges))


def found(mechanism: Mechanism, gains: PidGains, rate: float) -> list[Trouble]:
    joints = tuple(hinge.name for hinge in mechanism.hinges)
    task = ControllerTask("mover", MotionFamily.POSITION_PID, joints, "effort", (gains,) * len(joints))
    return list(loop_troubles(mechanism, [task], rate))


@pytest.mark.parametrize(("d", "expected"), [(0.15, []), (9.0, ["UC918"]), (12.0, ["UC916"])])
def test_a_rotor_of_a_twentieth_of_a_kilogram_square_metre_may_steady_a_joint(d: float, expected: list[str]) -> None:
    """Held for a period T, a damping of 2 J / T turns the speed round: 0.2 at 100 Hz, and 10.2 with a rotor."""
    assert [trouble.code for trouble in found(turning(0.001), PidGains(p=0.1, d=d), 100.0)] == expected


@pytest.mark.parametrize("d", [0.0, 0.5])
def test_a_joint_that_swings_is_named_with_a_d_that_damps_it(d: float) -> None:
    (trouble,) = found(turning(1.0), PidGains(p=1000.0, d=d), 1000.0)
    if d:
        assert (trouble.code, trouble.subject) == ("UC917", "gain:mover/d")
        assert "leave joint '" in trouble.message
    assert trouble.notes == ("with the 1 kg m² that it moves, a d of 44 damps it",)
    assert found(turning(1.0), PidGains(p=1000.0, d=44.0), 1000.0) == []


def test_what_rings_for_less_than_a_quarter_of_a_second_does_not_swing() -> None:
    assert found(turning(0.001), PidGains(p=8.0, d=0.95), 500.0) == []


@pytest.mark.parametrize(("joints", "sizes"), [(12, [12]), (13, [1] * 13)])
def test_joints_of_more_than_twelve_are_judged_alone(
    joints: int, sizes: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []

    def closed(inertia: list[list[float]], *_: object) -> tuple[float, float]:
        seen.append(len(inertia))
        return 0.9, 1.0

    monkeypatch.setattr(stability, "closed_loop", closed)
    assert found(turning(1.0, joints), PidGains(p=10.0, d=1.0), 1000.0) == []
    assert seen == sizes


@pytest.mark.parametrize(("i", "expected"), [(250.0, []), (230.0, ["UC966"])])
def test_the_integral_part_has_two_seconds_to_lift_a_weight(i: float, expected: list[str]) -> None:
    """98.1 N on a slide of 1 m may sag by 0.1 m: p + 2 s * i must be 981 N/m."""
    hinge = Hinge("j", "prismatic", parent="base", child="arm", pose=Pose(), axis=UP)._replace(lower=0.0, upper=1.0)
    slide = Mechanism("base", {"base": LinkBody("base"), "arm": LinkBody("arm", 10.0)}, (hinge,))
    task = ControllerTask("mover", MotionFamily.POSITION_PID, ("j",), "effort", (PidGains(p=500.0, i=i, d=200.0),))
    assert [trouble.code for trouble in loop_troubles(slide, [task], 1000.0)] == expected


# -- small matrices ----------------------------------------------------------------------------------------------------


def test_the_exponential_of_a_rotation_turns_by_its_angle() -> None:
    for angle in (0.0, 0.3, 40.0):
        turned = exponential([[0.0, -angle], [angle, 0.0]])
        assert turned[0] == pytest.approx([math.cos(angle), -math.sin(angle)], abs=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_eigenvalues_agree_with_those_of_numpy(seed: int) -> None:
    numpy = pytest.importorskip("numpy")
    chance = random.Random(seed)  # noqa: S311 (a sample)
    matrix = [[chance.uniform(-2, 2) for _ in range(9)] for _ in range(9)]
    ours = sorted(eigenvalues(matrix), key=lambda value: (round(value.real, 6), value.imag))
    theirs = sorted(map(complex, numpy.linalg.eigvals(matrix)), key=lambda value: (round(value.real, 6), value.imag))
    assert ours == pytest.approx(theirs, abs=1e-7)
