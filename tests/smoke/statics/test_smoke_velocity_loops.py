"""Loops that command velocities, and wheels whose loops need the ground: stable gains are quiet, others are named."""

from __future__ import annotations

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.loops.stability import loop_troubles, needs_grip
from urdfctl.smoke.statics.loops.velocity_loops import growth_of, velocity_loop_troubles
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily, PidGains

PERIOD = 0.01


def turning() -> Mechanism:
    hinge = Hinge("turn", "continuous", "base", "arm", Pose(), (0.0, 0.0, 1.0))
    return Mechanism("base", {"base": LinkBody("base"), "arm": LinkBody("arm", 1.0)}, (hinge,))


def told(gains: PidGains, *, interface: str = "velocity") -> list[str]:
    task = ControllerTask("mover", MotionFamily.TRAJECTORY, ("turn",), interface, (gains,))
    return [trouble.message for trouble in velocity_loop_troubles(turning(), [task], 1 / PERIOD)]


def simulated_growth(gains: PidGains) -> float:
    """By which factor an error grows in each period, from the loop itself, run step by step."""
    error, speed, total, size = 1.0, 0.0, 0.0, 1.0
    for _ in range(400):
        speed, before = gains.p * error + gains.i * total - gains.d * speed, error
        error, total = error - PERIOD * speed, total + PERIOD * before
        size = max(abs(error), abs(speed) * PERIOD, 1e-300)
    return float(size ** (1 / 400))


@pytest.mark.parametrize("gains", [PidGains(p=250.0), PidGains(p=-5.0), PidGains(p=20.0, d=1.2)])
def test_a_velocity_loop_grows_as_fast_as_it_does_step_by_step(gains: PidGains) -> None:
    assert growth_of(gains, PERIOD) == pytest.approx(simulated_growth(gains), rel=0.02)


@pytest.mark.parametrize(
    "gains", [PidGains(p=5.0), PidGains(p=60.0, i=1.0), PidGains(p=20.0, d=0.2), PidGains(feed=1.0)]
)
def test_stable_gains_of_a_velocity_loop_are_quiet(gains: PidGains) -> None:
    assert told(gains) == []


def test_a_gain_that_is_negative_too_high_or_missing_is_named() -> None:
    [negative] = told(PidGains(p=-5.0))
    assert "p of joint 'turn' is -5, which pushes it away from its target" in negative
    [high] = told(PidGains(p=500.0))
    assert "p of joint 'turn' is 500, but is stable only up to 2e+02 at 100 Hz" in high
    [none] = told(PidGains())
    assert none.endswith("for joint 'turn' are 0: nothing moves or holds it")


def test_a_loop_that_commands_positions_is_no_velocity_loop() -> None:
    assert told(PidGains(p=500.0), interface="position") == []


def rover(mass: float) -> Mechanism:
    hinge = Hinge("wheel", "continuous", "base", "rim", Pose(), (0.0, 1.0, 0.0))
    inertia = ((0.01, 0.0, 0.0), (0.0, 0.02, 0.0), (0.0, 0.0, 0.01))
    rim = LinkBody("rim", 1.0, inertia=inertia, radius=0.2)
    return Mechanism("base", {"base": LinkBody("base", mass), "rim": rim}, (hinge,))


def test_a_wheel_that_moves_its_share_of_the_robot_bears_higher_gains() -> None:
    task = ControllerTask("drive", MotionFamily.VELOCITY_PID, ("wheel",), "effort", (PidGains(p=200.0),))
    light, heavy = rover(0.0), rover(100.0)
    assert [trouble.code for trouble in loop_troubles(light, [task], 1000.0)] != []
    assert list(loop_troubles(heavy, [task], 1000.0)) == []
    assert needs_grip(heavy, task, 1000.0)
    assert not needs_grip(heavy, task._replace(gains=(PidGains(p=2.0),)), 1000.0)


def test_a_position_loop_that_commands_velocities_is_judged_as_a_trajectory_is() -> None:
    task = ControllerTask("mover", MotionFamily.POSITION_PID, ("turn",), "velocity", (PidGains(p=250.0),))
    [trouble] = velocity_loop_troubles(turning(), [task], 1 / PERIOD)
    assert trouble.code == "UC916"
    assert "p of joint 'turn' is 250" in trouble.message
    task = task._replace(gains=(PidGains(p=20.0),))
    assert list(velocity_loop_troubles(turning(), [task], 1 / PERIOD)) == []
