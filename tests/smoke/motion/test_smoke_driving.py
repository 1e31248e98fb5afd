"""A base that an engine which obeys drives: how far, as its controller's measures say, and what is drawn of it."""

from __future__ import annotations

import math

import pytest
from smoke_obedient import Obedient, hinge, trial

from urdfctl.model.geometry import Pose, of_angles
from urdfctl.smoke.motion.mobile_base import facing_of, with_measured_wheels
from urdfctl.smoke.motion.trial import MotionTrial
from urdfctl.smoke.robot.mechanism import LinkBody, Mechanism
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily, PidGains

WHEELS = tuple(hinge(name, f"{name}w", type="continuous", velocity=20.0) for name in ("l", "r"))
PAIR = Drive(("l",), ("r",), radius=0.1, separation=0.4)
"""As the wheels of the engine are."""


def driven(drive: Drive = PAIR, engine: str = "pybullet", **fields: object) -> MotionTrial:
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=drive)._replace(**fields)  # type: ignore[arg-type]
    return trial(Obedient(), WHEELS, (task,), fixed=False, engine=engine)


@pytest.mark.parametrize(("engine", "expected"), [("pybullet", ["UC941"]), ("mujoco", [])])
def test_wheels_slip_more_in_one_engine_than_in_the_other(engine: str, expected: list[str]) -> None:
    """The controller takes the wheels as larger than they are: it drives four fifths of the way."""
    assert [trouble.code for trouble in driven(PAIR._replace(radius=0.125), engine).troubles] == expected


def test_the_curves_of_a_base_are_its_way_ahead_and_its_turn() -> None:
    """0.3 m/s and 0.5 rad/s for 2 s."""
    ahead, yaw = driven().curves
    assert (ahead.quantity, ahead.commanded[-1], ahead.measured[-1]) == ("ahead", *[pytest.approx(0.6, rel=0.05)] * 2)
    assert (yaw.quantity, yaw.commanded[-1], yaw.measured[-1]) == ("yaw", *[pytest.approx(1.0, rel=0.05)] * 2)
    assert (ahead.unit, yaw.unit) == ("m", "rad")


def test_a_base_that_does_not_drive_straight_is_not_turned() -> None:
    assert [curve.quantity for curve in driven(PAIR._replace(radius=0.3)).curves] == ["ahead"]


def test_a_base_of_unknown_measures_is_not_driven() -> None:
    made = driven(PAIR._replace(separation=0.0))
    assert made.unjudged == {"base": "not simulated: the radius or separation of its wheels is unknown"}


class Pushed(Obedient):
    """An engine that notes which joints are pushed by efforts."""

    def __init__(self) -> None:
        super().__init__()
        self.pushed: set[str] = set()

    def with_effort(self, joint: str, effort: float) -> None:
        self.pushed.add(joint)


@pytest.mark.parametrize(
    ("joints", "gains", "plain", "pushed"),
    [
        (("l", "r"), (PidGains(p=1.0), PidGains(p=1.0)), False, {"l", "r"}),
        (("l", "r", "arm"), (PidGains(p=1.0),) * 3, False, {"l", "r"}),
        (("l", "r"), (), False, set()),
        (("l", "r"), (PidGains(p=1.0), PidGains(p=1.0)), True, set()),
    ],
)
def test_the_loops_of_its_wheels_drive_a_base(
    joints: tuple[str, ...], gains: tuple[PidGains, ...], plain: bool, pushed: set[str]
) -> None:
    engine = Pushed()
    task = ControllerTask(
        "base", MotionFamily.DIFFERENTIAL, joints, "effort", gains, drive=PAIR._replace(is_inferred=plain)
    )
    trial(engine, (*WHEELS, hinge("arm", "a")), (task,), fixed=False)
    assert engine.pushed == pushed


# -- measures --------------------------------------------------------------------------------------------------------


def robot(turn: float = 0.0) -> Mechanism:
    placed = [wheel._replace(pose=Pose((0.0, y, 0.0))) for wheel, y in zip(WHEELS, (0.2, -0.2), strict=True)]
    frame = hinge("mount", "frame", type="fixed", pose=Pose((0.0, 0.0, 0.0), of_angles(0.0, 0.0, turn)))
    bodies = {
        "base": LinkBody("base"),
        "frame": LinkBody("frame"),
        "lw": LinkBody("lw", radius=0.1),
        "rw": LinkBody("rw", radius=0.1),
    }
    return Mechanism("base", bodies, (*placed, frame))


def test_a_controller_without_measures_takes_those_of_the_robot() -> None:
    bare = with_measured_wheels(robot(), Drive(("l",), ("r",)))
    assert (bare.radius, bare.separation) == pytest.approx((0.1, 0.4))
    own = with_measured_wheels(robot(), Drive(("l",), ("r",), radius=0.2, separation=0.5))
    assert (own.radius, own.separation) == (0.2, 0.5)
    assert with_measured_wheels(robot(), Drive(("nowhere",), ("r",))).radius == 0.1
    assert with_measured_wheels(robot(), Drive(driven=("l",))).separation == 0.0


@pytest.mark.parametrize("turn", [0.0, 1.0, math.pi - 0.1, -2.0])
def test_forward_is_where_the_frame_of_the_controller_faces(turn: float) -> None:
    assert facing_of(robot(turn), Drive(base="frame")) == pytest.approx(turn)
    assert facing_of(robot(turn), Drive(base="nowhere")) == 0.0


# -- wheels with rollers ---------------------------------------------------------------------------------------------

PLACES = {"fl": (0.2, 0.3), "fr": (0.2, -0.3), "rl": (-0.2, 0.3), "rr": (-0.2, -0.3)}
ROLES = (("fl", 1, 1), ("fr", 1, -1), ("rl", -1, 1), ("rr", -1, -1))


class Rolling(Obedient):
    """An engine whose wheels turn as fast as they are commanded."""

    def step(self) -> None:
        for name, speed in self.speeds.items():
            self.places[name] = self.places.get(name, 0.0) + 0.001 * speed


@pytest.mark.parametrize(("reach", "fixed", "codes"), [(0.5, True, []), (0.7, True, ["UC942"]), (0.5, False, [])])
def test_wheels_with_rollers_turn_in_the_air_long_enough_to_be_judged(
    reach: float, fixed: bool, codes: list[str]
) -> None:
    drive = Drive(driven=tuple(PLACES), radius=0.1, reach=reach, roles=ROLES)
    wheels = tuple(
        hinge(name, f"{name}w", type="continuous", velocity=20.0, pose=Pose((x, y, 0.0)))
        for name, (x, y) in PLACES.items()
    )
    task = ControllerTask("base", MotionFamily.ROLLERS, tuple(PLACES), "velocity", rolling=drive)
    made = trial(Rolling(), wheels, (task,), fixed=fixed)
    assert [trouble.code for trouble in made.troubles] == codes
    assert made.acts == ({"base": "rolls"} if fixed else {})
    assert all(0.3 < curve.seconds[-1] < 1.0 and curve.quantity == "velocity" for curve in made.curves)
    assert len(made.curves) == (4 if fixed else 0)
