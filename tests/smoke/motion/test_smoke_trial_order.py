"""The order of a trial: what an engine is told first, which joints move at the same time, and what ends it once."""

from __future__ import annotations

import pytest
from smoke_obedient import Obedient, hinge, trial

from urdfctl.smoke.engines.engine import EngineSetup, RobotRejected
from urdfctl.smoke.motion import trial as trials
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.trial import MotionTrial, run_trial
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains

LEADER, OTHER = hinge("leader", "a"), hinge("other", "b")
MOVER = ControllerTask("mover", MotionFamily.FORWARD, ("leader",), "position")
SECOND = ControllerTask("second", MotionFamily.FORWARD, ("other",), "position")
WHEELS = tuple(hinge(name, f"{name}w", type="continuous") for name in ("l", "r", "l2", "r2"))
SKID = Drive(("l", "l2"), ("r", "r2"), radius=0.1, separation=0.4)


def codes(made: MotionTrial) -> list[str]:
    return [trouble.code for trouble in made.troubles]


# -- before anything moves ---------------------------------------------------------------------------------------------


def setup_of(monkeypatch: pytest.MonkeyPatch, task: ControllerTask, *hinges: Hinge, **bodies: LinkBody) -> EngineSetup:
    """Return what an engine is told, which then refuses the robot."""
    told: list[EngineSetup] = []

    def refusing(_name: str, setup: EngineSetup) -> Obedient:
        told.append(setup)
        raise RobotRejected("no")

    monkeypatch.setattr(trials, "open_engine", refusing)
    known = {name: bodies.get(name, LinkBody(name)) for name in ("base", *(one.child for one in hinges))}
    plan = MotionPlan("pybullet", "", Mechanism("base", known, hinges), (task,), 100.0, fixed=False)
    assert run_trial(plan).refused == "no"
    return told[0]


def test_an_engine_is_told_which_wheels_skid_and_how_parts_grip(monkeypatch: pytest.MonkeyPatch) -> None:
    skidding = ControllerTask("base", MotionFamily.DIFFERENTIAL, SKID.wheels, "velocity", drive=SKID)
    slick, afloat = LinkBody("lw", grip=0.3), LinkBody("rw", falls=False)
    told = setup_of(monkeypatch, skidding, *WHEELS, OTHER, lw=slick, rw=afloat)
    assert set(told.skidding) == {"lw", "rw", "l2w", "r2w"}
    assert (told.grips, told.weightless) == ({"lw": 0.3}, ["rw"])
    two = skidding._replace(drive=Drive(("l",), ("r",), radius=0.1, separation=0.4))
    assert setup_of(monkeypatch, two, *WHEELS).skidding == {}


def test_an_engine_is_told_which_joints_resist(monkeypatch: pytest.MonkeyPatch) -> None:
    hinges = (LEADER._replace(damping=0.5), OTHER._replace(friction=0.2), hinge("third", "c"))
    told = setup_of(monkeypatch, MOVER, *hinges, hinge("mount", "d", type="fixed", damping=1.0))
    assert told.resist == {"leader": (0.0, 0.5), "other": (0.2, 0.0)}


class Recording(Obedient):
    """An engine that notes which joints were held at a position, and which at a velocity."""

    def __init__(self) -> None:
        super().__init__(touching=frozenset(wheel.child for wheel in WHEELS))
        self.held: set[str] = set()
        self.turned: set[str] = set()

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        super().to_position(joint, position, effort, velocity)
        self.held.add(joint)

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        super().at_velocity(joint, velocity, effort)
        self.turned.add(joint)


def test_a_base_settles_on_braked_wheels_and_free_casters_with_its_other_joints_held() -> None:
    base = ControllerTask(
        "base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=Drive(("l",), ("r",), radius=0.1)
    )
    hinges = (*WHEELS[:2], hinge("caster", "c", type="continuous"), hinge("mast", "m"))
    standing = Recording()
    trial(standing, hinges, (base,), fixed=False)
    assert (standing.turned, standing.held) == ({"l", "r"}, {"mast"})
    hanging = Recording()
    trial(hanging, hinges[2:], (), fixed=True)
    assert hanging.held == {"caster", "mast"}


# -- at the same time --------------------------------------------------------------------------------------------------


class Disturbed(Obedient):
    """An engine in which a joint shakes while both joints are commanded at the same time."""

    def __init__(self) -> None:
        super().__init__()
        self.tick = 0
        self.commanded = {"leader": -1000, "other": -1000}
        self.efforts: list[float] = []

    @property
    def both(self) -> bool:
        return max(self.commanded.values()) - min(self.commanded.values()) < 20 and self.tick > 600

    def step(self) -> None:
        super().step()
        self.tick += 1

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        super().to_position(joint, position, effort, velocity)
        self.commanded[joint] = self.tick

    def with_effort(self, joint: str, effort: float) -> None:
        self.commanded[joint] = self.tick
        if self.both:
            self.efforts.append(abs(effort))

    def position(self, joint: str) -> float:
        shaking = 0.1 if self.both and joint == "other" and self.tick % 20 < 10 else 0.0
        return super().position(joint) + shaking

    def velocity(self, joint: str) -> float:
        return 1.0 if self.both else 0.0


def test_a_motor_that_another_one_disturbs_is_tested_again_alone() -> None:
    made = trial(Disturbed(), (LEADER, OTHER), (MOVER, SECOND))
    assert (codes(made), sorted(made.moved)) == ([], ["mover", "second"])
    both = MOVER._replace(joints=("leader", "other"))
    assert codes(trial(Disturbed(), (LEADER, OTHER), (both,))) != []


HOLDS = MOVER._replace(family=MotionFamily.POSITION_PID, interface="effort", gains=(PidGains(p=1.0),))
FOLLOWS = SECOND._replace(family=MotionFamily.TRAJECTORY, interface="effort", gains=(PidGains(p=1.0),))


def test_loops_that_are_still_alone_are_run_together_with_a_small_step() -> None:
    """With a gain of 1 the effort is the distance to the target: the joints stay where they are."""
    engine = Disturbed()
    assert "UC934" in codes(trial(engine, (LEADER, OTHER), (HOLDS, FOLLOWS)))
    assert 0.03 < min(engine.efforts) <= max(engine.efforts) < 0.16
    assert sum(effort < 0.06 for effort in engine.efforts) > 0.4 * len(engine.efforts)


@pytest.mark.parametrize(
    "tasks",
    [(HOLDS,), (HOLDS, SECOND), (HOLDS, FOLLOWS._replace(family=MotionFamily.VELOCITY_PID))],
    ids=["one loop", "a loop and a motor", "a loop of velocities"],
)
def test_there_is_nothing_to_run_together_with_one_loop_of_positions(tasks: tuple[ControllerTask, ...]) -> None:
    assert "UC934" not in codes(trial(Disturbed(), (LEADER, OTHER), tasks))


class Thrown(Obedient):
    """An engine in which a joint swings, and that notes which joints are put back."""

    def __init__(self, swinging: float) -> None:
        super().__init__()
        self.swinging, self.tick = swinging, 0
        self.put: dict[str, float] = {}

    def step(self) -> None:
        super().step()
        self.tick += 1

    def position(self, joint: str) -> float:
        return super().position(joint) + (self.swinging if joint == "leader" and self.tick % 20 < 10 else 0.0)

    def place(self, joint: str, position: float) -> None:
        super().place(joint, position)
        self.put[joint] = position


@pytest.mark.parametrize(
    ("swinging", "fixed", "put"),
    [(0.3, True, {"leader": 0.0, "other": 0.5}), (0.0, True, {}), (0.3, False, {})],
    ids=["a joint swings", "nothing fails", "on the ground"],
)
def test_after_a_failure_the_joints_of_a_fixed_robot_are_put_back(
    swinging: float, fixed: bool, put: dict[str, float]
) -> None:
    engine = Thrown(swinging)
    made = trial(engine, (LEADER, OTHER._replace(initial=0.5)), (MOVER,), fixed=fixed)
    assert (bool(made.troubles), engine.put) == (swinging > 0, put)


# -- the end -----------------------------------------------------------------------------------------------------------


class Bursting(Obedient):
    """An engine that explodes as soon as a joint moves."""

    def position(self, joint: str) -> float:
        place = super().position(joint)
        return place if place < 0.05 else float("nan")


def test_an_explosion_is_reported_once_for_the_controller_that_moved() -> None:
    made = trial(Bursting(), (LEADER, OTHER), (MOVER, SECOND._replace(interface="velocity")))
    assert [(trouble.code, trouble.controller) for trouble in made.troubles] == [("UC930", "mover")]


def test_what_was_not_modelled_is_said_of_controllers_that_did_something_only() -> None:
    own = ControllerTask("own", MotionFamily.STRUCTURAL, why="it is of your own")
    made = trial(Obedient(), (LEADER, OTHER), (MOVER, own)).result()
    assert set(made.tested) == set(made.untested) == {"mover"}


def test_only_the_links_that_a_controller_moves_need_a_mass() -> None:
    bodies = {"base": LinkBody("base", 1.0), "a": LinkBody("a", 1.0), "b": LinkBody("b")}
    plan = MotionPlan("mujoco", "", Mechanism("base", bodies, (LEADER, OTHER)), (MOVER,), 100.0, fixed=True)
    assert "mass" not in trials.untested_joints(plan, MOVER, "")
    assert trials.untested_joints(plan, SECOND, "")["mass"] == "link 'b' has none; 1 g was taken"
