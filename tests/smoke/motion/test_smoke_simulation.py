"""What is drawn of a simulation, and what ends it, in an engine that obeys."""

from __future__ import annotations

import pytest
from smoke_obedient import Obedient, hinge

from urdfctl.smoke.engines.engine import STEP, BasePose
from urdfctl.smoke.motion.motions import motion_of
from urdfctl.smoke.motion.plan import MotionPlan
from urdfctl.smoke.motion.simulation import Exploded, OutOfTime, RobotSimulation, Tipped
from urdfctl.smoke.results import Curve
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.tasks.goals import Goal
from urdfctl.smoke.tasks.task import ControllerTask, MotionFamily, PidGains

JOINT = hinge("j", "arm")
POSITION = ControllerTask("arm", MotionFamily.FORWARD, ("j",), "position")


def simulation(
    engine: Obedient, *hinges: Hinge, tasks: tuple[ControllerTask, ...] = (), **fields: object
) -> RobotSimulation:
    bodies = {name: LinkBody(name) for name in ("base", *(one.child for one in hinges))}
    plan = MotionPlan("mujoco", "", Mechanism("base", bodies, hinges), tasks, 100.0, fixed=True)
    return RobotSimulation(plan._replace(**fields), engine, 0.0 if fields.get("budget") == 0.0 else 1e9)  # type: ignore[arg-type]


class Loaded(Obedient):
    """An engine whose motors give 5 N m."""

    def effort(self, joint: str) -> float:
        return 5.0


def curve_of(task: ControllerTask, joint: Hinge = JOINT, seconds: float = 2.0) -> Curve:
    """Return the curve of a joint that a controller moves by 0.2 rad."""
    engine = Loaded()
    made, goal = simulation(engine, joint), Goal(joint, 0.0, 0.2)
    [tracks] = made.tracked([(motion_of(engine, task, [goal], seconds), [goal])], seconds)
    [curve] = made.curves(task, [goal], tracks)
    return curve


@pytest.mark.parametrize("seconds", [1.0, 2.0, 5.0])
def test_a_curve_has_enough_samples_to_be_drawn_and_few_enough_to_be_sent(seconds: float) -> None:
    curve = curve_of(POSITION, seconds=seconds)
    assert 40 < len(curve.seconds) < 130
    assert len(curve.seconds) == len(curve.commanded) == len(curve.measured) == len(curve.efforts)
    assert curve.seconds[0] == 0.01
    assert seconds * 0.9 < curve.seconds[-1] <= seconds


def test_a_short_motion_is_drawn_whole() -> None:
    assert len(curve_of(POSITION, seconds=0.3).seconds) == 30


@pytest.mark.parametrize(
    ("task", "quantity", "is_commanded", "has_band", "limits", "unit"),
    [
        (POSITION, "position", True, True, (-1.0, 1.0), "rad"),
        (POSITION._replace(interface="velocity"), "velocity", True, False, (-1.0, 1.0), "rad/s"),
        (POSITION._replace(interface="effort"), "position", False, False, (-1.0, 1.0), "rad"),
        (POSITION._replace(family=MotionFamily.TRAJECTORY), "position", True, True, (-1.0, 1.0), "rad"),
        (
            ControllerTask("arm", MotionFamily.VELOCITY_PID, ("j",), "velocity", (PidGains(),)),
            "velocity",
            True,
            False,
            (-1.0, 1.0),
            "rad/s",
        ),
    ],
)
def test_a_curve_shows_the_quantity_that_is_judged(
    task: ControllerTask, quantity: str, is_commanded: bool, has_band: bool, limits: tuple[float, float], unit: str
) -> None:
    curve = curve_of(task)
    assert (curve.quantity, bool(curve.commanded), curve.band is not None) == (quantity, is_commanded, has_band)
    assert (curve.limits, curve.unit) == (limits, unit)


@pytest.mark.parametrize(
    ("fields", "limits", "unit"),
    [
        ({"type": "continuous"}, None, "rad"),
        ({"lower": None}, None, "rad"),
        ({"upper": None}, None, "rad"),
        ({"type": "prismatic"}, (-1.0, 1.0), "m"),
    ],
)
def test_only_limits_that_a_joint_has_are_drawn(
    fields: dict[str, object], limits: tuple[float, float] | None, unit: str
) -> None:
    curve = curve_of(POSITION, JOINT._replace(**fields))  # type: ignore[arg-type]
    assert (curve.limits, curve.unit) == (limits, unit)


def test_a_joint_without_a_velocity_limit_has_none_in_its_curve() -> None:
    assert curve_of(POSITION._replace(interface="velocity"), JOINT._replace(velocity=None)).limits is None


@pytest.mark.parametrize(("limit", "share"), [(10.0, 50.0), (20.0, 25.0), (None, None), (0.0, None)])
def test_efforts_are_shares_of_the_limit(limit: float | None, share: float | None) -> None:
    assert set(curve_of(POSITION, JOINT._replace(effort=limit)).efforts) == ({share} if share else set())


@pytest.mark.parametrize(("quantity", "unit"), [("yaw", "rad"), ("ahead", "m")])
def test_the_curve_of_a_base_has_the_unit_of_its_way(quantity: str, unit: str) -> None:
    assert simulation(Obedient()).curve("base", "base", quantity, [], [0.1]).unit == unit


# -- what ends a simulation ------------------------------------------------------------------------------------------


class Leaning(Obedient):
    """An engine whose robot pitches at once."""

    def __init__(self, pitch: float) -> None:
        super().__init__()
        self.pitch = pitch

    def base_pose(self) -> BasePose:
        return super().base_pose()._replace(pitch=self.pitch)


@pytest.mark.parametrize(("pitch", "tips"), [(0.44, False), (0.46, True), (-0.24, False), (-0.26, True)])
def test_a_robot_tips_if_it_turns_by_a_third_of_a_radian_from_where_it_rested(pitch: float, tips: bool) -> None:
    """It rests with a pitch of 0.1 rad."""
    made = simulation(Leaning(pitch))
    made.update()
    made.at_rest = Leaning(0.1).base_pose()
    if tips:
        with pytest.raises(Tipped):
            made.update()
    else:
        made.update()


@pytest.mark.parametrize("place", [float("nan"), float("inf"), 2e4])
def test_a_joint_that_is_nowhere_ends_it(place: float) -> None:
    engine = Obedient()
    made = simulation(engine, JOINT)
    engine.places["j"] = 9e3
    made.update()
    engine.places["j"] = place
    with pytest.raises(Exploded):
        made.update()


def test_the_end_of_its_time_ends_it() -> None:
    with pytest.raises(OutOfTime):
        simulation(Obedient(), budget=0.0).update()


@pytest.mark.parametrize(("rate", "period"), [(100.0, 0.01), (1000.0, 0.001), (9000.0, STEP)])
def test_controllers_are_updated_at_their_rate_but_not_between_steps(rate: float, period: float) -> None:
    assert simulation(Obedient(), rate=rate).period == pytest.approx(period)


MIMIC = hinge("m", "thumb", mimic=("j", 2.0, 0.1))


def test_a_mimic_joint_is_led_unless_a_controller_moves_it() -> None:
    engine = Obedient()
    engine.places["j"] = 0.2
    simulation(engine, JOINT, MIMIC).update()
    assert engine.places["m"] == pytest.approx(0.5)
    own = Obedient()
    simulation(own, JOINT, MIMIC, tasks=(POSITION._replace(joints=("m",)),)).update()
    assert "m" not in own.places
    alone = Obedient()
    simulation(alone, MIMIC).update()
    assert "m" not in alone.places


@pytest.mark.parametrize(("rate", "updates"), [(1000.0, 10), (200.0, 2), (50.0, 1)])
def test_a_robot_is_watched_once_in_ten_milliseconds(rate: float, updates: int) -> None:
    made = simulation(Obedient(), budget=0.0, rate=rate)
    for _ in range(updates - 1):
        made.update()
    with pytest.raises(OutOfTime):
        made.update()
