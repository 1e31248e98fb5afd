"""Each tolerance of the motion checks is pinned from both sides: just inside nothing is found, just outside it is."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.engines.engine import BasePose
from urdfctl.smoke.motion.checks import (
    Journey,
    Track,
    forward_troubles,
    joint_troubles,
    together_troubles,
    turn_troubles,
)
from urdfctl.smoke.robot.mechanism import Hinge
from urdfctl.smoke.tasks.goals import Goal
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains

HINGE = Hinge(
    name="j", type="revolute", parent="a", child="b", pose=Pose(), axis=(0, 0, 1), lower=-1.0, upper=1.0, velocity=1.0
)
STILL = 100
"""Values in a track."""


def moved_to(place: float, peak: float = 0.0, swing: float = 0.0, speed: float = 0.0) -> Track:
    """Return a track to a place, with a peak velocity on the way, and a swing and speed in its last quarter."""
    last = STILL // 4
    swings = [place - swing if n % 2 else place for n in range(last)]
    speeds = [speed if n % 2 else -speed for n in range(last)]
    start = [place * n / (STILL - last) for n in range(STILL - last)]
    velocities = [peak] + [0.0] * (STILL - last - 1)
    return Track(start + swings[::-1] if last % 2 == 0 else start + swings, velocities + speeds, [], [])


def codes(task: ControllerTask, track: Track, by: float = 0.2, weight: float = 0.0, hinge: Hinge = HINGE) -> list[str]:
    goal = Goal(hinge, 0.0, by, weight)
    return [trouble.code for trouble in joint_troubles(task, [goal], [track], 2.0)]


TRAJECTORY = ControllerTask("arm", MotionFamily.TRAJECTORY, ("j",), "position", (PidGains(),))
PUSHED_BY = ControllerTask("arm", MotionFamily.TRAJECTORY, ("j",), "effort", (PidGains(p=10.0),))
VELOCITY = ControllerTask("arm", MotionFamily.FORWARD, ("j",), "velocity")
EFFORT = ControllerTask("arm", MotionFamily.FORWARD, ("j",), "effort")
LOOP = ControllerTask("arm", MotionFamily.VELOCITY_PID, ("j",), "effort", (PidGains(p=1.0),))


@pytest.mark.parametrize(
    ("task", "weight", "efforts", "expected"),
    [
        (PUSHED_BY, 9.0, [0.0] * STILL, "its load of 9 N m is more than its effort limit of 5 N m"),
        (PUSHED_BY, 4.0, [5.0] * STILL, "its motor is at its effort limit of 5 N m: raise the limit, or lower"),
        (PUSHED_BY, 4.0, [4.9] * STILL, "raise the d gain"),
        (TRAJECTORY, 4.0, [-5.0] * STILL, "its motor is at its effort limit"),
        (TRAJECTORY, 4.0, [], "the hardware holds the position"),
    ],
)
def test_a_joint_that_falls_is_not_told_to_change_its_gains(
    task: ControllerTask, weight: float, efforts: list[float], expected: str
) -> None:
    goal = Goal(HINGE._replace(effort=5.0), 0.0, 0.2, weight)
    track = moved_to(0.2, swing=0.05, speed=0.2)._replace(efforts=efforts)
    [trouble] = joint_troubles(task, [goal], [track], 2.0)
    assert trouble.notes[0].startswith(expected)


@pytest.mark.parametrize(("task", "has_gains"), [(TRAJECTORY, False), (PUSHED_BY, True)])
def test_advice_on_gains_is_for_controllers_that_have_gains(task: ControllerTask, has_gains: bool) -> None:
    goal = Goal(HINGE, 0.0, 0.2, 0.0)
    for track in (moved_to(0.2, swing=0.05, speed=0.2), moved_to(0.0)):
        (trouble,) = joint_troubles(task, [goal], [track], 2.0)
        assert trouble.notes
        assert any("gain" in note for note in trouble.notes) == has_gains


@pytest.mark.parametrize(("step", "error", "expected"), [(0.2, 0.048, []), (0.2, 0.052, ["UC932"])])
def test_a_joint_may_miss_its_target_by_a_quarter_of_its_step(step: float, error: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(step - error), step) == expected


@pytest.mark.parametrize(("error", "expected"), [(0.009, []), (0.011, ["UC932"])])
def test_a_joint_with_a_small_step_may_miss_its_target_by_a_hundredth(error: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(0.02 - error), 0.02) == expected


@pytest.mark.parametrize(("error", "expected"), [(0.0019, []), (0.0021, ["UC932"])])
def test_a_joint_with_a_tiny_step_may_miss_its_target_by_half_of_it(error: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(0.004 - error), 0.004) == expected


@pytest.mark.parametrize(("place", "expected"), [(0.0439, []), (0.0441, ["UC936"]), (-0.0041, ["UC936"])])
def test_a_finger_may_exceed_its_limits_by_a_tenth_of_its_range(place: float, expected: list[str]) -> None:
    finger = HINGE._replace(type="prismatic", lower=0.0, upper=0.04)
    assert codes(TRAJECTORY, moved_to(place), place, hinge=finger) == expected


@pytest.mark.parametrize(("error", "expected"), [(0.14, []), (0.16, ["UC932"])])
def test_a_joint_may_sag_by_one_and_a_half_times_its_weight_over_its_gain(error: float, expected: list[str]) -> None:
    assert codes(PUSHED_BY, moved_to(0.2 - error), weight=1.0) == expected


@pytest.mark.parametrize(
    ("swing", "speed", "expected"),
    [(0.05, 0.2, ["UC933"]), (0.03, 0.2, []), (0.05, 0.08, []), (0.041, 0.101, ["UC933"])],
)
def test_a_joint_oscillates_if_it_swings_far_and_fast(swing: float, speed: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(0.2, swing=swing, speed=speed)) == expected


@pytest.mark.parametrize(("place", "expected"), [(1.019, []), (1.021, ["UC936"]), (-1.019, []), (-1.021, ["UC936"])])
def test_a_joint_may_exceed_its_limits_by_a_fiftieth(place: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(place), place) == expected


def test_a_joint_without_end_has_no_limits() -> None:
    endless = HINGE._replace(type="continuous")
    assert codes(TRAJECTORY, moved_to(50.0), 50.0, hinge=endless) == []


@pytest.mark.parametrize(("peak", "expected"), [(1.205, []), (1.215, ["UC937"]), (-1.215, ["UC937"])])
def test_a_joint_may_exceed_its_velocity_limit_by_a_fifth(peak: float, expected: list[str]) -> None:
    assert codes(TRAJECTORY, moved_to(0.2, peak=peak)) == expected


def test_the_velocity_limit_has_a_little_slack_for_slow_joints() -> None:
    slow = HINGE._replace(velocity=0.01)
    assert codes(TRAJECTORY, moved_to(0.2, peak=0.021), hinge=slow) == []
    assert codes(TRAJECTORY, moved_to(0.2, peak=0.023), hinge=slow) == ["UC937"]


@pytest.mark.parametrize(("place", "expected"), [(0.11, []), (0.09, ["UC935"]), (-0.15, ["UC935"])])
def test_a_velocity_command_moves_a_joint_at_least_half_as_far(place: float, expected: list[str]) -> None:
    assert codes(VELOCITY, moved_to(place)) == expected


@pytest.mark.parametrize(("speed", "expected"), [(0.39, []), (0.41, ["UC935"])])
def test_a_velocity_loop_runs_away_at_twice_its_target(speed: float, expected: list[str]) -> None:
    assert codes(LOOP, moved_to(0.4, speed=speed)) == expected


@pytest.mark.parametrize(("place", "expected"), [(0.00011, []), (0.00009, ["UC935"]), (-0.01, ["UC935"])])
def test_an_effort_moves_a_joint_its_way(place: float, expected: list[str]) -> None:
    assert codes(EFFORT, moved_to(place)) == expected


@pytest.mark.parametrize(
    ("swing", "speed", "expected"), [(0.021, 0.11, ["UC934"]), (0.019, 0.11, []), (0.021, 0.09, [])]
)
def test_loops_disturb_each_other_from_a_small_swing_on(swing: float, speed: float, expected: list[str]) -> None:
    goal = Goal(HINGE, 0.0, 0.05)
    found = together_troubles([PUSHED_BY], [goal], [moved_to(0.05, swing=swing, speed=speed)])
    assert [trouble.code for trouble in found] == expected


# -- mobile bases ----------------------------------------------------------------------------------------------------


START = BasePose(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
TWO = Drive(("l",), ("r",), radius=0.1, separation=0.4)
FOUR = Drive(("l", "ll"), ("r", "rr"), radius=0.1, separation=0.4)
STEERED = Drive(driven=("d",), steered=("s",), radius=0.1, wheelbase=1.0)
BASE = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=TWO)


def journey(ahead: float = 1.0, yaw: float = 0.0, facing: float = 0.0) -> Journey:
    """Return a journey for which 1 m and 1 rad were commanded."""
    return Journey(START, START._replace(x=ahead), yaw, 1.0, 1.0, facing=facing)


@pytest.mark.parametrize(
    ("ahead", "expected"), [(0.86, []), (0.84, ["UC941"]), (1.14, []), (1.16, ["UC941"]), (-1.0, ["UC941"])]
)
def test_a_base_drives_about_as_far_as_commanded(ahead: float, expected: list[str]) -> None:
    assert [trouble.code for trouble in forward_troubles(BASE, journey(ahead))] == expected


@pytest.mark.parametrize(
    ("ahead", "note"),
    [
        (-0.11, "the wheels turn backwards"),
        (-0.09, "the wheels do not roll"),
        (0.09, "the wheels do not roll"),
        (0.11, "the wheels slip, or their real radius is 0.11 times"),
    ],
)
def test_the_note_names_what_a_distance_tells(ahead: float, note: str) -> None:
    (trouble,) = forward_troubles(BASE, journey(ahead))
    assert trouble.notes[0].startswith(note)


@pytest.mark.parametrize(("yaw", "expected"), [(0.14, []), (0.16, ["UC941"]), (-0.16, ["UC941"])])
def test_a_base_that_drives_straight_hardly_turns(yaw: float, expected: list[str]) -> None:
    assert [trouble.code for trouble in forward_troubles(BASE, journey(yaw=yaw))] == expected


@pytest.mark.parametrize(("rolled", "note"), [(0.79, "the wheels do not reach their speed"), (0.81, "the wheels slip")])
def test_wheels_that_turn_too_little_are_too_weak(rolled: float, note: str) -> None:
    (trouble,) = forward_troubles(BASE, journey(0.5)._replace(rolled=rolled))
    assert trouble.notes[0].startswith(note)


def test_the_ranges_are_wider_in_an_engine_whose_wheels_slip() -> None:
    assert list(forward_troubles(BASE, journey(0.61, 0.39), slipping=0.25)) == []
    assert [t.code for t in forward_troubles(BASE, journey(0.59), slipping=0.25)] == ["UC941"]
    assert [t.code for t in forward_troubles(BASE, journey(1.0, 0.41), slipping=0.25)] == ["UC941"]


def test_forward_is_where_the_frame_of_the_controller_faces() -> None:
    assert list(forward_troubles(BASE, journey(-1.0, facing=math.pi))) == []
    assert [t.code for t in forward_troubles(BASE, journey(1.0, facing=math.pi))] == ["UC941"]


@pytest.mark.parametrize(
    ("drive", "yaw", "expected"),
    [
        (TWO, 0.81, []),
        (TWO, 0.79, ["UC942"]),
        (TWO, 1.19, []),
        (TWO, 1.21, ["UC942"]),
        (TWO, -1.0, ["UC942"]),
        (FOUR, 0.06, []),
        (FOUR, 0.04, ["UC942"]),
        (FOUR, -0.5, ["UC942"]),
        (FOUR, 5.0, []),
        (STEERED, 0.31, []),
        (STEERED, 0.29, ["UC942"]),
        (STEERED, 1.49, []),
        (STEERED, 1.51, ["UC942"]),
    ],
)
def test_a_base_turns_about_as_far_as_commanded(drive: Drive, yaw: float, expected: list[str]) -> None:
    assert [trouble.code for trouble in turn_troubles(BASE, drive, journey(yaw=yaw))] == expected


def test_a_base_that_turns_the_wrong_way_gets_a_note() -> None:
    (trouble,) = turn_troubles(BASE, TWO, journey(yaw=-1.0))
    assert trouble.notes[0].startswith("it turns the other way")
    (short,) = turn_troubles(BASE, TWO, journey(yaw=0.1))
    assert short.notes == ()


def test_a_base_must_turn_a_little_even_where_wheels_slip() -> None:
    assert [t.code for t in turn_troubles(BASE, FOUR, journey(yaw=0.04), slipping=0.25)] == ["UC942"]
    assert list(turn_troubles(BASE, TWO, journey(yaw=0.56), slipping=0.25)) == []
    assert [t.code for t in turn_troubles(BASE, TWO, journey(yaw=1.46), slipping=0.25)] == ["UC942"]
