"""The motions of joints and wheels: within limits and ranges, smooth, and as their controllers compute them."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.motion.motions import ForwardMotion, PidLoop, WheelMotion, motion_of, ramp, ramp_velocity
from urdfctl.smoke.robot.mechanism import Hinge
from urdfctl.smoke.tasks.goals import effort_of, fastest, goal_of, speed_of, turning_of
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains

JOINT = Hinge(
    "j", "revolute", parent="a", child="b", pose=Pose(), axis=(0.0, 0.0, 1.0), lower=-2.0, upper=2.0, effort=50.0
)
FINGER = JOINT._replace(type="prismatic", lower=0.0, upper=0.02)


class Recorder:
    """An engine that only notes the last command of each joint."""

    def __init__(self, position: float = 0.0, velocity: float = 0.0) -> None:
        self.place, self.speed = position, velocity
        self.positions: dict[str, float] = {}
        self.velocities: dict[str, float] = {}
        self.efforts: dict[str, float] = {}

    def position(self, joint: str) -> float:
        return self.place

    def velocity(self, joint: str) -> float:
        return self.speed

    def to_position(self, joint: str, position: float, effort: float, velocity: float) -> None:
        self.positions[joint] = position

    def at_velocity(self, joint: str, velocity: float, effort: float) -> None:
        self.velocities[joint] = velocity

    def with_effort(self, joint: str, effort: float) -> None:
        self.efforts[joint] = effort


# -- the step of a joint ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("start", [-0.5, -0.1, 0.0, 0.47, 0.5])
@pytest.mark.parametrize("hinge", [JOINT._replace(lower=-0.5, upper=0.5), FINGER, JOINT._replace(lower=0.0, upper=0.1)])
def test_a_joint_moves_within_its_limits_from_anywhere(hinge: Hinge, start: float) -> None:
    low, high = hinge.span
    goal = goal_of(hinge, min(max(start, low), high), 0.0, 2.0)
    assert low <= goal.end <= high
    assert 0.05 < abs(goal.by) / (high - low) < 0.2


def test_a_joint_moves_up_unless_it_is_near_its_upper_limit() -> None:
    assert goal_of(JOINT, 1.7, 0.0, 2.0).by > 0
    assert goal_of(JOINT, 1.9, 0.0, 2.0).by < 0


@pytest.mark.parametrize(("kind", "least", "most"), [("revolute", 0.1, 0.5), ("prismatic", 0.02, 0.1)])
def test_a_joint_with_a_wide_range_moves_visibly_but_not_far(kind: str, least: float, most: float) -> None:
    assert least < goal_of(JOINT._replace(type=kind, lower=-50.0, upper=50.0), 0.0, 0.0, 2.0).by < most


@pytest.mark.parametrize("limit", [0.01, 0.05, 0.1])
def test_a_ramp_takes_most_of_the_velocity_limit_but_not_more(limit: float) -> None:
    goal = goal_of(JOINT._replace(velocity=limit), 0.0, 0.0, 2.0)
    peak = max(ramp_velocity(goal, n / 100, 2.0) for n in range(200))
    assert 0.5 * limit < peak <= limit


@pytest.mark.parametrize(
    ("least", "most", "inside"), [(0.5, 3.0, True), (1.992, 9.0, True), (1.998, 9.0, False), (5.0, 9.0, False)]
)
def test_a_joint_moves_in_the_range_of_its_commands_if_there_is_one(least: float, most: float, inside: bool) -> None:
    """The joint's own range is 4 rad; a thousandth of that is hardly a range."""
    goal = goal_of(JOINT._replace(ranges=(("position", least, most),)), 2.0 if inside else 0.0, 0.0, 2.0)
    assert (abs(goal.by) <= 0.11 * (2.0 - least)) == inside


# -- ramps and steps -------------------------------------------------------------------------------------------------


def test_a_ramp_is_smooth_and_ends_at_half_of_the_time() -> None:
    goal = goal_of(JOINT, 0.5, 0.0, 2.0)
    assert (ramp(goal, 0.0, 2.0), ramp(goal, 1.0, 2.0), ramp(goal, 1.7, 2.0)) == pytest.approx((0.5, 0.7, 0.7))
    assert ramp(goal, 0.5, 2.0) == pytest.approx(0.6)
    for n in range(1, 20):
        rise = (ramp(goal, n / 10 + 1e-6, 2.0) - ramp(goal, n / 10 - 1e-6, 2.0)) / 2e-6
        assert ramp_velocity(goal, n / 10, 2.0) == pytest.approx(rise, abs=1e-5)


def test_a_command_is_a_ramp_of_positions_or_a_step_of_velocity() -> None:
    engine, goal = Recorder(), goal_of(JOINT, 0.0, 0.0, 2.0)
    ForwardMotion(engine, [goal], "position", 2.0).update(0.5, 0.01)  # type: ignore[arg-type]
    ForwardMotion(engine, [goal], "velocity", 2.0).update(0.5, 0.01)  # type: ignore[arg-type]
    assert (engine.positions["j"], engine.velocities["j"]) == pytest.approx((0.1, 0.1))
    assert engine.efforts == {}


@pytest.mark.parametrize(("limit", "weight"), [(50.0, 5.0), (50.0, -5.0), (1.0, 0.5), (None, 5.0)])
def test_an_effort_carries_the_weight_and_pushes_a_little(limit: float | None, weight: float) -> None:
    engine, hinge = Recorder(), JOINT._replace(effort=limit)
    ForwardMotion(engine, [goal_of(hinge, 0.0, weight, 2.0)], "effort", 2.0).update(0.0, 0.01)  # type: ignore[arg-type]
    extra = engine.efforts["j"] - weight
    assert 0.5 * min(1.0, 0.2 * (limit or 100.0)) < extra < 2 * min(1.0, 0.2 * (limit or 100.0))
    assert abs(engine.efforts["j"]) <= effort_of(hinge)


def test_a_light_joint_is_pushed_gently() -> None:
    engine, goal = Recorder(), goal_of(JOINT, 0.0, 5.0, 2.0)._replace(push=0.01)
    ForwardMotion(engine, [goal], "effort", 2.0).update(0.0, 0.01)  # type: ignore[arg-type]
    assert engine.efforts["j"] == pytest.approx(5.01)


def test_an_effort_is_at_most_the_limit() -> None:
    engine = Recorder()
    ForwardMotion(engine, [goal_of(JOINT, 0.0, 49.9, 2.0)], "effort", 2.0).update(0.0, 0.01)  # type: ignore[arg-type]
    assert engine.efforts["j"] == 50.0


# -- loops -----------------------------------------------------------------------------------------------------------


def loop(engine: Recorder, gains: PidGains, interface: str = "effort", *, of_velocity: bool = False) -> PidLoop:
    """Return a loop towards 0.2 rad and 0.1 rad/s."""
    goals = [goal_of(JOINT._replace(velocity=2.0), 0.0, 0.0, 2.0)]
    return PidLoop(engine, goals, [gains], interface, lambda *_: (0.2, 0.1), of_velocity=of_velocity)  # type: ignore[arg-type]


def test_a_loop_of_positions_is_the_textbook_pid_with_feedforward() -> None:
    """The error is 0.15 rad and changes by 0.1 - 0.3 rad/s."""
    engine = Recorder(0.05, 0.3)
    made = loop(engine, PidGains(p=10.0, i=4.0, d=2.0, feed=5.0))
    made.update(0.0, 0.01)
    assert engine.efforts["j"] == pytest.approx(10.0 * 0.15 + 4.0 * 0.15 * 0.01 + 2.0 * -0.2 + 5.0 * 0.1)
    assert made.wanted(0) == 0.2


def test_a_loop_of_velocities_takes_the_difference_of_its_errors() -> None:
    engine = Recorder(0.05, 0.3)
    made = loop(engine, PidGains(p=10.0, d=2.0), of_velocity=True)
    made.update(0.0, 0.01)
    assert engine.efforts["j"] == pytest.approx(10.0 * -0.2)
    engine.speed = 0.29
    made.update(0.01, 0.01)
    assert engine.efforts["j"] == pytest.approx(10.0 * -0.19 + 2.0 * 0.01 / 0.01)
    assert made.wanted(0) == 0.1


def test_the_integral_part_is_clamped_and_the_output_limited() -> None:
    engine = Recorder()
    clamped = loop(engine, PidGains(i=100.0, clamp=0.5))
    for _ in range(10):
        clamped.update(0.0, 0.01)
    assert engine.efforts["j"] == 0.5
    loop(engine, PidGains(p=1e6)).update(0.0, 0.01)
    assert engine.efforts["j"] == 50.0
    loop(engine, PidGains(p=1e6), "velocity").update(0.0, 0.01)
    assert engine.velocities["j"] == 2.0
    loop(engine, PidGains(p=math.inf, d=math.inf)).update(0.0, 0.01)
    assert engine.efforts["j"] <= 50.0


@pytest.mark.parametrize(
    ("family", "interface", "expected"),
    [
        (MotionFamily.FORWARD, "position", ForwardMotion),
        (MotionFamily.FORWARD, "effort", ForwardMotion),
        (MotionFamily.TRAJECTORY, "position", ForwardMotion),
        (MotionFamily.TRAJECTORY, "velocity", PidLoop),
        (MotionFamily.TRAJECTORY, "effort", PidLoop),
        (MotionFamily.POSITION_PID, "position", ForwardMotion),
        (MotionFamily.POSITION_PID, "effort", PidLoop),
        (MotionFamily.VELOCITY_PID, "effort", PidLoop),
    ],
)
def test_a_controller_closes_a_loop_unless_it_forwards_what_it_holds(
    family: MotionFamily, interface: str, expected: type
) -> None:
    engine, goal = Recorder(), goal_of(JOINT, 0.0, 0.0, 2.0)
    motion = motion_of(engine, ControllerTask("c", family, ("j",), interface, (PidGains(p=1.0),)), [goal], 2.0)  # type: ignore[arg-type]
    assert type(motion) is expected


# -- wheels ----------------------------------------------------------------------------------------------------------

PAIR = Drive(("l",), ("r",), radius=0.1, separation=0.4)
WHEELS = {name: JOINT._replace(name=name, type="continuous") for name in ("l", "r", "d", "s")}


def test_the_slowest_wheel_limits_a_base() -> None:
    slow = [WHEELS["l"]._replace(velocity=2.0), WHEELS["r"]._replace(velocity=1.0)]
    assert fastest(PAIR, slow) == pytest.approx(0.1)
    assert 0.05 < speed_of(PAIR, slow) < 0.1
    assert speed_of(PAIR._replace(speed=0.02), slow) == 0.02
    assert fastest(PAIR, [WHEELS["l"]]) == math.inf


@pytest.mark.parametrize(("speed", "turning"), [(1.0, 9.0), (0.05, 9.0), (1.0, 0.1)])
def test_a_base_turns_no_faster_than_its_wheels_and_its_controller_allow(speed: float, turning: float) -> None:
    rate = turning_of(PAIR._replace(turning=turning), speed)
    assert 0.1 <= rate <= min(1.0, turning, 2 * speed / 0.4)


def commanded(drive: Drive, forward: float, turning: float, sides: dict[str, float] | None = None) -> Recorder:
    engine = Recorder()
    WheelMotion(engine, WHEELS, drive, forward, turning, sides or {}).update(0.0, 0.01)  # type: ignore[arg-type]
    return engine


@pytest.mark.parametrize(("forward", "turning"), [(0.3, 0.0), (0.0, 0.5), (-0.2, 0.3)])
def test_two_wheels_turn_as_fast_as_their_rims_move(forward: float, turning: float) -> None:
    expected = {"l": (forward - 0.2 * turning) / 0.1, "r": (forward + 0.2 * turning) / 0.1}
    assert commanded(PAIR, forward, turning).velocities == pytest.approx(expected)


def test_the_speed_rises_as_fast_as_the_controller_allows() -> None:
    wheels = WheelMotion(Recorder(), WHEELS, PAIR._replace(acceleration=1.0), 0.3, 0.0, {})  # type: ignore[arg-type]
    for n in range(100):
        wheels.update(n * 0.01, 0.01)
    assert wheels.distance == pytest.approx(0.3 - 0.3**2 / 2, abs=0.003)


def test_a_bicycle_steers_at_the_angle_of_its_circle_but_not_too_far() -> None:
    """tan = wheelbase times the rate over the speed."""
    bicycle = Drive(driven=("d",), steered=("s",), radius=0.1, wheelbase=0.6)
    gentle = commanded(bicycle, 0.3, 0.1)
    assert gentle.positions["s"] == pytest.approx(math.atan(0.6 * 0.1 / 0.3))
    assert gentle.velocities["d"] == pytest.approx(3.0)
    assert 0.3 < commanded(bicycle, 0.1, 0.5).positions["s"] < 0.8
    assert -0.8 < commanded(bicycle, 0.1, -0.5).positions["s"] < -0.3
    assert commanded(bicycle, 0.3, 0.0).positions["s"] == 0.0


def test_the_inner_wheel_of_a_steered_base_turns_slower() -> None:
    bicycle = Drive(driven=("d",), steered=("s",), radius=0.1, wheelbase=0.6)
    made = commanded(bicycle, 0.3, 0.1, {"d": 0.2, "s": 0.2})
    assert made.velocities["d"] == pytest.approx((0.3 - 0.2 * 0.1) / 0.1)
    assert made.positions["s"] == pytest.approx(math.atan(0.6 * 0.1 / (0.3 - 0.2 * 0.1)))
