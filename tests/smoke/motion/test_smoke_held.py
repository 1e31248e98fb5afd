"""A legged robot on the ground while its joints are held: when it counts as standing, in an engine that obeys."""

from __future__ import annotations

import math

import pytest
from smoke_obedient import Obedient, hinge

from urdfctl.smoke.engines.engine import STEP, BasePose, EngineSetup
from urdfctl.smoke.motion import standing
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.standing import why_not_standing
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily, PidGains

SINKS, TIPS = "it sinks down while its joints are held", "it tips over while its joints are held"


class Legged(Obedient):
    """An engine whose robot is 0.5 m high, sinks to a part of that, and rolls over after some seconds."""

    def __init__(self, part: float = 1.0, roll: float = 0.0, after: float = 0.0) -> None:
        super().__init__()
        self.part, self.roll_later, self.after, self.time = part, roll, after, 0.0
        self.pushed: dict[str, float] = {}

    def step(self) -> None:
        super().step()
        self.time += STEP

    def with_effort(self, joint: str, effort: float) -> None:
        self.pushed[joint] = effort

    def base_pose(self) -> BasePose:
        z = 0.5 * (1 - (1 - self.part) * min(1.0, self.time / 0.9))
        return BasePose(0.0, 0.0, z, self.roll_later if self.time >= self.after > 0 else 0.0, 0.0, 0.0)


def stood(
    monkeypatch: pytest.MonkeyPatch, engine: Obedient, joint: Hinge | None = None, task: ControllerTask | None = None
) -> tuple[str, dict[str, float]]:
    """Return why a robot does not stand, and where its joints began."""
    leg = joint or hinge("knee", "shin")
    mechanism = Mechanism("base", {"base": LinkBody("base", 1.0), "shin": LinkBody("shin", 0.1)}, (leg,))
    tasks = (task or ControllerTask("legs", MotionFamily.FORWARD, ("knee",), "position"),)
    plan = MotionPlan("mujoco", "", mechanism, tasks, 100.0, fixed=True, ground_urdf="<robot/>")
    setups: list[EngineSetup] = []

    def opened(_name: str, setup: EngineSetup) -> Obedient:
        setups.append(setup)
        return engine

    monkeypatch.setattr(standing, "open_engine", opened)
    told = why_not_standing(plan, EngineSetup("", "base", True, mechanism.start()), 1e9)
    assert (setups[0].urdf, setups[0].fixed) == ("<robot/>", False)
    return told, dict(setups[0].start)


@pytest.mark.parametrize(("part", "told"), [(1.0, ""), (0.71, ""), (0.69, SINKS)])
def test_a_robot_that_sinks_by_a_third_does_not_stand(part: float, told: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert stood(monkeypatch, Legged(part))[0] == told


@pytest.mark.parametrize(("roll", "told"), [(0.34, ""), (0.36, TIPS), (-0.36, TIPS)])
def test_a_robot_that_rolls_by_a_third_of_a_radian_does_not_stand(
    roll: float, told: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert stood(monkeypatch, Legged(roll=roll, after=0.1))[0] == told


@pytest.mark.parametrize(("after", "told"), [(0.8, TIPS), (1.3, "")])
def test_a_robot_is_watched_for_a_second(after: float, told: str, monkeypatch: pytest.MonkeyPatch) -> None:
    assert stood(monkeypatch, Legged(roll=1.0, after=after))[0] == told


@pytest.mark.parametrize(
    ("fields", "least", "most"),
    [
        ({}, 0.01, 0.05),
        ({"upper": 0.0}, -0.05, -0.01),
        ({"initial": 0.5}, 0.51, 0.55),
        ({"upper": 0.01}, 0.0, 0.0),
        ({"type": "prismatic"}, 0.0, 0.0),
    ],
)
def test_legs_begin_a_little_bent_within_their_limits(
    fields: dict[str, object], least: float, most: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Legs that are exactly straight would not bend."""
    _, start = stood(monkeypatch, Legged(), hinge("knee", "shin", **fields))
    assert least <= start["knee"] <= most


def test_joints_are_held_by_their_motors_or_by_the_loops_that_push_them(monkeypatch: pytest.MonkeyPatch) -> None:
    bent = hinge("knee", "shin", initial=0.5)
    motors = Legged()
    stood(monkeypatch, motors, bent)
    assert (motors.places["knee"], motors.pushed) == (0.5, {})
    loops = Legged()
    task = ControllerTask("legs", MotionFamily.TRAJECTORY, ("knee",), "effort", (PidGains(p=10.0),))
    stood(monkeypatch, loops, bent, task)
    assert ("knee" in loops.places, loops.pushed) == (False, {"knee": pytest.approx(5.0)})
    turned = Legged()
    stood(monkeypatch, turned, bent, task._replace(family=MotionFamily.VELOCITY_PID))
    assert (turned.places["knee"], turned.pushed) == (0.5, {})


def test_a_robot_that_flies_away_is_told_so(monkeypatch: pytest.MonkeyPatch) -> None:
    assert stood(monkeypatch, Legged(part=math.nan))[0] == "the simulation explodes on the ground"
