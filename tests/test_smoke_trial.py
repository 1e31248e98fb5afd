"""A trial in an engine without physics: its joints go where they are told, and each check is set off alone."""

from __future__ import annotations

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.engines import Standing
from urdfctl.smoke.mechanism import Body, Hinge, Mechanism
from urdfctl.smoke.plan import Plan
from urdfctl.smoke.tasks import Drive, Family, Task
from urdfctl.smoke.trial import Trial


class Obedient:
    """An engine whose joints reach every command at once, and whose base drives as two wheels roll it."""

    def __init__(
        self, *, off: float = 0.0, touching: frozenset[str] = frozenset({"lw", "rw"}), roll: float = 0.0
    ) -> None:
        self.off, self.ground, self.roll = off, touching, roll
        self.places: dict[str, float] = {}
        self.speeds: dict[str, float] = {}
        self.x = self.yaw = 0.0

    def position(self, joint: str) -> float:
        return self.places.get(joint, 0.0) + (self.off if joint == "follower" else 0.0)

    def velocity(self, joint: str) -> float:
        return self.speeds.get(joint, 0.0)

    def effort(self, joint: str) -> float:
        return 0.0

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        assert effort >= 0 <= velocity
        self.places[joint] = position

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        assert effort >= 0
        self.speeds[joint] = velocity

    def with_effort(self, joint: str, effort: float) -> None:
        self.places[joint] = effort

    def step(self) -> None:
        left, right = (0.1 * self.speeds.get(name, 0.0) for name in ("l", "r"))
        self.x += 0.0005 * (left + right)
        for name in ("l", "r"):
            self.places[name] = self.places.get(name, 0.0) + 0.001 * self.speeds.get(name, 0.0)
        self.yaw += 0.001 * (right - left) / 0.4

    def standing(self) -> Standing:
        return Standing(self.x, 0.0, 0.0, self.roll, 0.0, self.yaw)

    def touching(self) -> set[str]:
        return set(self.ground)

    def close(self) -> None:
        pass


def hinge(name: str, child: str, **fields: object) -> Hinge:
    made = Hinge(
        name, "revolute", "base", child, Pose(), (0.0, 1.0, 0.0), lower=-1.0, upper=1.0, effort=10.0, velocity=1.0
    )
    return made._replace(**fields)  # type: ignore[arg-type]


def trial(engine: Obedient, hinges: tuple[Hinge, ...], tasks: tuple[Task, ...], **fields: object) -> Trial:
    bodies = {name: Body(name) for name in ("base", *(one.child for one in hinges))}
    plan = Plan("mujoco", "", Mechanism("base", bodies, hinges), tasks, 100.0, fixed=True)._replace(**fields)  # type: ignore[arg-type]
    made = Trial(plan, engine, (), 0.0 if fields.get("budget") == 0.0 else 1e9)
    made.run()
    return made


def codes(made: Trial) -> list[str]:
    return [trouble.code for trouble in made.troubles]


JOINTS = (hinge("leader", "a"), hinge("follower", "b", mimic=("leader", 1.0, 0.0)))
MOVER = Task("mover", Family.FORWARD, ("leader",), "position")
WHEELS = (hinge("l", "lw", type="continuous"), hinge("r", "rw", type="continuous"))
ROLLER = Task(
    "roller", Family.DIFFERENTIAL, ("l", "r"), "velocity", drive=Drive(("l",), ("r",), radius=0.1, separation=0.4)
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


def test_a_wheel_off_the_ground_is_not_judged_where_collision_geometry_is_missing() -> None:
    made = trial(Obedient(touching=()), WHEELS, (ROLLER,), fixed=False, shapeless=True)
    assert codes(made) == []
    assert made.unjudged == {"roller": "not simulated: collision geometry under the robot is missing"}


@pytest.mark.parametrize(("roll", "expected"), [(0.34, []), (0.36, ["UC931"]), (-0.36, ["UC931"])])
def test_a_robot_tips_over_from_a_third_of_a_radian_on(roll: float, expected: list[str]) -> None:
    assert codes(trial(Obedient(roll=roll), WHEELS, (ROLLER,), fixed=False)) == expected


def test_a_position_far_away_is_an_explosion() -> None:
    made = trial(Obedient(off=2e4), JOINTS, (MOVER,))
    assert codes(made) == ["UC930"]


def test_a_trial_that_is_out_of_time_says_how_far_it_came_and_finds_nothing() -> None:
    made = trial(Obedient(), JOINTS, (MOVER, MOVER._replace(controller="other")), budget=0.0)
    assert codes(made) == []
    assert made.unjudged["other"] == "not tested: too slow: 0 of 2 controllers tested in 0 s"


def test_a_joint_without_a_range_is_not_simulated() -> None:
    made = trial(Obedient(), (hinge("leader", "a", lower=0.0, upper=0.0),), (MOVER,))
    assert made.unjudged == {"mover": "not simulated: joint 'leader' has no range of motion"}


def test_a_controller_that_only_reads_needs_no_joint() -> None:
    made = trial(Obedient(), JOINTS, (Task("states", Family.NOTHING),))
    assert made.acts == {"states": "reads"}
