"""A user's task in an engine that obeys: how far its end may be off, for joints and for a base."""

from __future__ import annotations

import pytest
from smoke_obedient import Late, Obedient, hinge, trial

from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains
from urdfctl.smoke.tasks.task_file import TaskStep, UserTask

JOINT = (hinge("follower", "b"),)
POSITION = ControllerTask("arm", MotionFamily.FORWARD, ("follower",), "position")
VELOCITY = ControllerTask("arm", MotionFamily.FORWARD, ("follower",), "velocity")
WHEELS = (hinge("l", "lw", type="continuous"), hinge("r", "rw", type="continuous"))
BASE = Drive(("l",), ("r",), radius=0.1, separation=0.4)
"""As the wheels of the engine are."""


def told(
    task: ControllerTask, kind: str, value: float, off: float = 0.0, engine: Obedient | None = None, **fields: float
) -> list[str]:
    """Return what is said of a task for one joint, which ends off its command by some rad or rad/s."""
    steps = (TaskStep(0.3, (("follower", value),), 1),)
    given = UserTask("arm", kind, steps, (0, 0), **fields)
    made = trial(engine or Obedient(off=off), JOINT, (task,), user_tasks=(given,))
    assert made.acts == {"arm": "performs"}
    return [f"{one.code} {one.subject}" for one in made.troubles]


NOT_PERFORMED = ["UC971 task:arm"]


@pytest.mark.parametrize("kind", ["target", "trajectory"])
@pytest.mark.parametrize(("off", "expected"), [(0.019, []), (0.021, NOT_PERFORMED), (-0.021, NOT_PERFORMED)])
def test_a_joint_ends_within_two_hundredths_of_its_target(kind: str, off: float, expected: list[str]) -> None:
    assert told(POSITION, kind, 0.5, off) == expected


@pytest.mark.parametrize(("seconds", "expected"), [(0.4, []), (0.7, NOT_PERFORMED)])
def test_a_joint_has_half_a_second_to_settle_at_its_target(seconds: float, expected: list[str]) -> None:
    assert told(POSITION, "target", 0.5, engine=Late(seconds)) == expected


@pytest.mark.parametrize(("tolerance", "expected"), [(0.04, NOT_PERFORMED), (0.06, []), (0.0, NOT_PERFORMED)])
def test_the_tolerance_of_the_user_counts_instead(tolerance: float, expected: list[str]) -> None:
    assert told(POSITION, "target", 0.5, 0.05, tolerance=tolerance) == expected


@pytest.mark.parametrize(("tolerance", "expected"), [(0.01, NOT_PERFORMED), (0.02, [])])
def test_a_path_is_watched_if_the_user_says_so(tolerance: float, expected: list[str]) -> None:
    assert told(POSITION, "target", 0.5, 0.015, path_tolerance=tolerance) == expected


@pytest.mark.parametrize(("off", "expected"), [(0.09, []), (0.11, NOT_PERFORMED), (-0.11, NOT_PERFORMED)])
def test_a_joint_holds_its_velocity_within_a_tenth(off: float, expected: list[str]) -> None:
    """The engine reaches it at once, but the command rises for 0.3 s; only the time after that is judged."""
    assert told(VELOCITY, "velocity", 0.5, off) == expected


def test_a_loop_of_velocities_holds_them_too() -> None:
    loop = ControllerTask("arm", MotionFamily.VELOCITY_PID, ("follower",), "velocity", (PidGains(feed=1.0),))
    assert told(loop, "velocity", 0.5) == []
    assert told(loop._replace(gains=(PidGains(feed=0.5),)), "velocity", 0.5) == NOT_PERFORMED


def test_a_task_beyond_the_limits_of_a_joint_is_reported_as_that() -> None:
    """The joint has limits of -1 and 1 rad."""
    assert told(POSITION, "target", 0.9, 0.2, tolerance=0.3) == ["UC936 joint:follower"]


def drive(forward: float, turn: float, engine: str = "pybullet", wheels: Drive = BASE, **fields: float) -> list[str]:
    """Return what is said of a base that drives for a second."""
    given = UserTask("base", "drive", (TaskStep(1.0, (("forward", forward), ("turn", turn)), 1),), (0, 0), **fields)
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=wheels)
    made = trial(Obedient(), WHEELS, (task,), fixed=False, engine=engine, user_tasks=(given,))
    return [trouble.code for trouble in made.troubles]


@pytest.mark.parametrize(
    ("engine", "factor", "expected"),
    [
        ("pybullet", 1.09, []),
        ("pybullet", 1.11, ["UC971"]),
        ("pybullet", 0.89, ["UC971"]),
        ("mujoco", 1.34, []),
        ("mujoco", 1.36, ["UC971"]),
    ],
)
def test_a_base_ends_within_a_tenth_of_a_metre(engine: str, factor: float, expected: list[str]) -> None:
    """It should drive 1 m with wheels that are larger than it knows. Those of MuJoCo slip by a quarter of the way."""
    assert drive(1.0, 0.0, engine, BASE._replace(radius=0.1 / factor)) == expected


@pytest.mark.parametrize(
    ("engine", "factor", "expected"),
    [("pybullet", 1.19, []), ("pybullet", 1.21, ["UC971"]), ("pybullet", 0.79, ["UC971"]), ("mujoco", 1.44, [])],
)
def test_a_base_turns_within_a_fifth_of_a_radian(engine: str, factor: float, expected: list[str]) -> None:
    assert drive(0.0, 1.0, engine, BASE._replace(separation=0.4 * factor)) == expected


def test_the_tolerances_of_the_user_count_for_a_base_too() -> None:
    far, turned = BASE._replace(radius=0.1 / 1.05), BASE._replace(separation=0.4 * 1.1)
    assert drive(1.0, 0.0, wheels=far, tolerance=0.04) == ["UC971"]
    assert drive(1.0, 0.0, wheels=far, tolerance=0.06) == []
    assert drive(0.0, 1.0, wheels=turned, angle_tolerance=0.09) == ["UC971"]
    assert drive(0.0, 1.0, wheels=turned, angle_tolerance=0.11) == []


SKID = Drive(("l", "l2"), ("r", "r2"), radius=0.1, separation=0.8)


@pytest.mark.parametrize(
    ("forward", "turn", "fields", "expected"),
    [
        (0.5, 0.5, {}, []),
        (0.5, 0.5, {"tolerance": 0.001}, ["UC971"]),
        (0.5, 0.5, {"angle_tolerance": 0.1}, ["UC971"]),
        (1.0, 0.15, {}, []),
    ],
)
def test_how_far_a_skidding_base_comes_in_a_turn_is_judged_only_by_tolerances_of_the_user(
    forward: float, turn: float, fields: dict[str, float], expected: list[str]
) -> None:
    """Its wheels roll twice as far in a turn as those of the engine, which turns by that."""
    given = UserTask("base", "drive", (TaskStep(1.0, (("forward", forward), ("turn", turn)), 1),), (0, 0), **fields)
    wheels = tuple(hinge(name, f"{name}w", type="continuous") for name in SKID.wheels)
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, SKID.wheels, "velocity", drive=SKID)
    engine = Obedient(touching=frozenset(wheel.child for wheel in wheels))
    made = trial(engine, wheels, (task,), fixed=False, engine="pybullet", user_tasks=(given,))
    assert [trouble.code for trouble in made.troubles] == expected


def test_only_the_curve_of_a_joint_with_a_target_shows_where_it_must_end() -> None:
    joints = (*JOINT, hinge("other", "c"))
    given = UserTask("arm", "target", (TaskStep(0.3, (("follower", 0.5),), 1),), (0, 0), tolerance=0.1)
    both = POSITION._replace(joints=("follower", "other"))
    made = trial(Obedient(), joints, (both,), user_tasks=(given,))
    assert {curve.joint: curve.band for curve in made.curves} == {"follower": pytest.approx((0.4, 0.6)), "other": None}
