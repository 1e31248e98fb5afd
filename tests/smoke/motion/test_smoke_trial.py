"""A trial in an engine without physics: its joints go where they are told, and each check is set off alone."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
from smoke_obedient import Obedient, hinge, trial

from urdfctl.smoke.engines.engine import STEP, BasePose
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.setup import skidding_joints, stiff_joints, wheel_joints
from urdfctl.smoke.motion.trial import (
    MotionTrial,
    seen_quantities,
    untested_joints,
)
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains


def codes(made: MotionTrial) -> list[str]:
    return [trouble.code for trouble in made.troubles]


JOINTS = (hinge("leader", "a"), hinge("follower", "b", mimic=("leader", 1.0, 0.0)))
MOVER = ControllerTask("mover", MotionFamily.FORWARD, ("leader",), "position")
WHEELS = (hinge("l", "lw", type="continuous"), hinge("r", "rw", type="continuous"))
ROLLER = ControllerTask(
    "roller", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=Drive(("l",), ("r",), radius=0.1, separation=0.4)
)


@pytest.mark.parametrize(("off", "expected"), [(0.019, []), (0.021, ["UC938"]), (-0.021, ["UC938"])])
def test_a_mimic_joint_may_be_a_little_off(off: float, expected: list[str]) -> None:
    assert codes(trial(Obedient(off=off), JOINTS, (MOVER,))) == expected


@pytest.mark.parametrize(("off", "expected"), [(0.0039, []), (0.0041, ["UC938"])])
def test_a_finger_may_be_off_by_a_tenth_of_its_range(off: float, expected: list[str]) -> None:
    fingers = tuple(joint._replace(type="prismatic", lower=0.0, upper=0.04) for joint in JOINTS)
    assert codes(trial(Obedient(off=off), fingers, (MOVER,))) == expected


def test_an_obedient_base_drives_and_turns() -> None:
    made = trial(Obedient(), WHEELS, (ROLLER,), fixed=False)
    assert codes(made) == []
    assert made.acts == {"roller": "drives"}


def test_each_driven_wheel_must_touch_the_ground() -> None:
    made = trial(Obedient(touching=("lw",)), WHEELS, (ROLLER,), fixed=False)
    assert [(trouble.code, trouble.subject) for trouble in made.troubles] == [("UC940", "joint:r")]


def rocking(parent: str) -> tuple[Hinge, ...]:
    """Two wheels, and a rocker on which the right one is if that is its parent."""
    left, right = WHEELS
    return left, hinge("rocker", "arm"), right._replace(parent=parent)


@pytest.mark.parametrize(
    ("parent", "family", "interface", "expected"),
    [
        ("arm", MotionFamily.FORWARD, "effort", []),
        ("base", MotionFamily.FORWARD, "effort", ["UC940"]),
        ("arm", MotionFamily.FORWARD, "position", ["UC940"]),
        ("arm", MotionFamily.POSITION_PID, "effort", ["UC940"]),
    ],
)
def test_a_wheel_on_a_joint_that_is_only_pushed_comes_down_to_the_ground(
    parent: str, family: MotionFamily, interface: str, expected: list[str]
) -> None:
    rocker = ControllerTask("rocker", family, ("rocker",), interface, gains=(PidGains(p=100.0),))
    made = trial(Obedient(touching=("lw",)), rocking(parent), (ROLLER, rocker), fixed=False)
    assert [code for code in codes(made) if code == "UC940"] == expected
    why = "not simulated: joint 'rocker' is part of a suspension, which the ground moves too"
    assert (made.unjudged.get("rocker") == why) is (not expected)


def test_a_wheel_off_the_ground_is_not_judged_where_collision_geometry_is_missing() -> None:
    made = trial(Obedient(touching=()), WHEELS, (ROLLER,), fixed=False, shapeless=True)
    assert codes(made) == []
    assert made.unjudged == {"roller": "not simulated: collision geometry under the robot is missing"}


@pytest.mark.parametrize(("roll", "expected"), [(0.34, []), (0.36, ["UC931"]), (-0.36, ["UC931"])])
def test_a_robot_tips_over_from_a_third_of_a_radian_on(roll: float, expected: list[str]) -> None:
    assert codes(trial(Obedient(roll=roll), WHEELS, (ROLLER,), fixed=False)) == expected


@pytest.mark.parametrize(("off", "code"), [(5e3, "UC938"), (2e4, "UC930"), (math.nan, "UC930")])
def test_a_position_far_away_or_nowhere_is_an_explosion(off: float, code: str) -> None:
    assert codes(trial(Obedient(off=off), JOINTS, (MOVER,))) == [code]


def test_a_trial_that_is_out_of_time_says_how_far_it_came_and_finds_nothing() -> None:
    made = trial(Obedient(), JOINTS, (MOVER, MOVER._replace(controller="other")), budget=0.0)
    assert codes(made) == []
    assert made.unjudged["other"] == "not tested: too slow: 0 of 2 controllers tested in 0 s"


def test_a_joint_without_a_range_is_not_simulated() -> None:
    made = trial(Obedient(), (hinge("leader", "a", lower=0.0, upper=0.0),), (MOVER,))
    assert made.unjudged == {"mover": "not simulated: joint 'leader' has no range of motion"}


def test_a_controller_that_only_reads_needs_no_joint() -> None:
    made = trial(Obedient(), JOINTS, (ControllerTask("states", MotionFamily.NOTHING),))
    assert made.acts == {"states": "reads"}


class Rocking(Obedient):
    """An engine whose robot rocks for some seconds before it stands."""

    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.left, self.roll = round(seconds / STEP), 1.0

    def step(self) -> None:
        super().step()
        self.left -= 1
        self.roll = 1.0 if self.left > 0 else 0.0


@pytest.mark.parametrize(("seconds", "expected"), [(0.4, []), (0.8, ["UC931"])])
def test_a_robot_has_half_a_second_to_settle(seconds: float, expected: list[str]) -> None:
    assert codes(trial(Rocking(seconds), WHEELS, (ROLLER,), fixed=False)) == expected


class Falling(Obedient):
    """An engine whose robot falls to the side as soon as it has driven some metres."""

    def base_pose(self) -> BasePose:
        return super().base_pose()._replace(roll=0.5 if self.x > 0.1 else 0.0)


def test_a_robot_that_tips_over_while_it_is_driven_ends_the_trial() -> None:
    later = ControllerTask("later", MotionFamily.NOTHING)
    made = trial(Falling(), WHEELS, (ROLLER, later), fixed=False)
    [trouble] = made.troubles
    assert (trouble.code, trouble.controller) == ("UC931", "roller")
    assert "while controller 'roller' drives it" in trouble.message
    assert made.unjudged == dict.fromkeys(("roller", "later"), "not simulated: the robot tipped over")


@pytest.mark.parametrize(
    ("task", "act"),
    [
        (MOVER, "follows"),
        (MOVER._replace(interface="velocity"), "moves"),
        (MOVER._replace(family=MotionFamily.TRAJECTORY), "follows"),
        (ControllerTask("states", MotionFamily.NOTHING), "reads"),
    ],
)
def test_a_controller_is_said_to_do_what_its_kind_does(task: ControllerTask, act: str) -> None:
    class Turning(Obedient):
        def step(self) -> None:
            super().step()
            for name, speed in self.speeds.items():
                self.places[name] = self.places.get(name, 0.0) + STEP * speed

    made = trial(Turning(), JOINTS, (task,))
    assert (codes(made), made.acts) == ([], {task.controller: act})


@pytest.mark.parametrize(
    ("task", "why"),
    [
        (ControllerTask("own", MotionFamily.STRUCTURAL, why="it is of your own"), "it is of your own"),
        (MOVER._replace(joints=("nowhere",)), "'nowhere' is not a movable joint"),
    ],
)
def test_a_controller_that_cannot_be_simulated_is_left_with_the_reason(task: ControllerTask, why: str) -> None:
    made = trial(Obedient(), JOINTS, (task,))
    assert (made.acts, made.unjudged) == ({}, {task.controller: f"not simulated: {why}"})


def test_a_base_that_one_controller_cannot_drive_is_not_tried_with_the_next() -> None:
    weak = ROLLER._replace(
        drive=Drive(("l",), ("r",), radius=0.3, separation=0.4, is_inferred=True), family=MotionFamily.FORWARD
    )
    made = trial(Obedient(), WHEELS, (weak, weak._replace(controller="other")), fixed=False)
    assert {trouble.controller for trouble in made.troubles} == {"roller"}
    assert made.unjudged["other"] == "not simulated: controller 'roller' cannot drive the base with its wheels"
    sound = weak._replace(drive=Drive(("l",), ("r",), radius=0.1, separation=0.4, is_inferred=True))
    assert trial(Obedient(), WHEELS, (sound, sound._replace(controller="other")), fixed=False).moved == [
        "roller",
        "other",
    ]


def test_the_positions_of_a_slow_manager_are_commanded_in_small_steps() -> None:
    """A manager of 5 Hz would move a joint of 0.2 rad in five jerks."""
    places: list[float] = []

    class Watched(Obedient):
        def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
            super().to_position(joint, position, effort, velocity)
            places.append(position)

    trial(Watched(), JOINTS[:1], (MOVER,), rate=5.0)
    assert 0.001 < max(abs(b - a) for a, b in pairwise(places)) < 0.01


# -- what engines cannot model -----------------------------------------------------------------------------------------


def plan(task: ControllerTask, hinges: tuple[Hinge, ...], inertia: float = 0.01, **fields: object) -> MotionPlan:
    square = ((inertia, 0.0, 0.0), (0.0, inertia, 0.0), (0.0, 0.0, inertia))
    bodies = {name: LinkBody(name, 0.0, inertia=square) for name in ("base", *(one.child for one in hinges))}
    made = MotionPlan("pybullet", "", Mechanism("base", bodies, hinges), (task,), 100.0, fixed=True)
    return made._replace(**fields)  # type: ignore[arg-type]


@pytest.mark.parametrize(("damping", "stiff"), [(4.9, ()), (5.1, ("leader",))])
def test_damping_that_halves_the_velocity_in_a_step_is_left_to_another_engine(
    damping: float, stiff: tuple[str, ...]
) -> None:
    """An inertia of 0.01 kg m² loses half of its velocity in 1 ms with 5 N m s/rad."""
    joints = (JOINTS[0]._replace(damping=damping),)
    pushed = MOVER._replace(interface="effort")
    assert stiff_joints(plan(pushed, joints)) == stiff
    assert stiff_joints(plan(pushed, joints, engine="mujoco")) == ()
    assert stiff_joints(plan(MOVER, joints)) == ()
    assert stiff_joints(plan(pushed._replace(joints=("other",)), joints)) == ()


def test_driven_wheels_and_what_a_pivot_turns_grip_the_ground() -> None:
    fork = hinge("s", "fork")
    wheel = hinge("w", "front", type="continuous")._replace(parent="fork")
    steered = ControllerTask("base", MotionFamily.STEERED, drive=Drive(driven=("l",), steered=("s",), radius=0.1))
    assert sorted(wheel_joints(plan(steered, (*WHEELS, fork, wheel)))) == ["fork", "front", "lw"]


def test_only_bases_of_more_than_two_wheels_skid() -> None:
    four = Drive(("l", "l2"), ("r", "r2"))
    assert skidding_joints(plan(ROLLER, WHEELS)) == set()
    assert skidding_joints(plan(ROLLER._replace(drive=four), WHEELS)) == {"l", "l2", "r", "r2"}


@pytest.mark.parametrize(
    ("task", "fixed", "missing"),
    [
        (MOVER, True, ["contact", "mass", "standing"]),
        (MOVER, False, ["contact", "mass"]),
        (ROLLER, False, ["friction", "mass"]),
        (ROLLER._replace(drive=Drive(("l", "l2"), ("r",))), False, ["friction", "mass", "turning rate"]),
        (ControllerTask("base", MotionFamily.ROLLERS, ("l",), rolling=Drive()), True, ["contact", "mass"]),
        (ControllerTask("states", MotionFamily.NOTHING), True, []),
    ],
)
def test_what_was_not_modelled_is_named(task: ControllerTask, fixed: bool, missing: list[str]) -> None:
    made = untested_joints(plan(task, (*JOINTS, *WHEELS), fixed=fixed), task, "the base is held in the air")
    assert sorted(made) == missing
    assert all("1 g was taken" in made[name] for name in missing if name == "mass")


@pytest.mark.parametrize(("act", "stood"), [("moves", True), ("follows", True), ("reads", False), ("drives", False)])
def test_a_robot_that_stood_did_so_with_each_controller_that_held_its_joints(act: str, stood: bool) -> None:
    assert ("stood" in seen_quantities(act, stood=True)) == stood
    assert "stood" not in seen_quantities(act, stood=False)
