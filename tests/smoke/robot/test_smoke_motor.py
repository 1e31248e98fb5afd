"""The motor of a joint against friction and damping, and the friction of links on the ground."""

from __future__ import annotations

import math

import pytest

from urdfctl.smoke.engines.engine import FREE_MOTOR, EngineSetup, Motor
from urdfctl.smoke.robot.wheels import friction_of


@pytest.mark.parametrize(
    ("motor", "effort", "top"),
    [
        (Motor(2.0, 4.0), 10.0, 2.0),
        (Motor(2.0, 4.0), 1.0, 0.0),
        (Motor(2.0, 0.0), 10.0, math.inf),
        (Motor(2.0, 0.0), 1.0, 0.0),
        (FREE_MOTOR, 0.1, math.inf),
    ],
)
def test_a_motor_turns_as_fast_as_friction_and_damping_leave_it(motor: Motor, effort: float, top: float) -> None:
    assert motor.top(effort) == top


@pytest.mark.parametrize(
    ("velocity", "wanted", "left"),
    [(0.5, 1.0, 6.0), (-0.5, -1.0, 6.0), (0.5, 0.0, 14.0), (-0.5, 0.0, 14.0), (0.0, 1.0, 8.0), (5.0, 9.0, 0.0)],
)
def test_friction_and_damping_slow_a_motor_and_help_it_to_brake(velocity: float, wanted: float, left: float) -> None:
    """They take 2 N m and 4 N m s/rad of 10 N m."""
    assert Motor(2.0, 4.0).left(10.0, wanted, velocity) == left
    assert FREE_MOTOR.left(10.0, wanted, velocity) == 10.0


def test_the_friction_of_the_description_counts_up_to_that_of_the_ground() -> None:
    """As in ODE, where the lower one of two surfaces counts."""
    assert [friction_of(given, is_wheel=True) for given in (0.0, 0.3, 1.0, 50.0)] == [0.0, 0.3, 1.0, 1.0]
    setup = EngineSetup("", "base", False, {}, wheels=("wheel",), grips={"ice": 0.01})
    assert setup.friction_of("ice") == 0.01
    assert setup.friction_of("caster") < 0.5 * setup.friction_of("wheel")
