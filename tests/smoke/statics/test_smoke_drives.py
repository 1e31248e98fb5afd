"""The wheels of a mobile base: where they are, which way they turn, and what is said of those that differ."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.geometry import Pose, Vector
from urdfctl.smoke.results import Trouble
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.statics.drives import drive_troubles
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily

LEFT, RIGHT, UP, DOWN = (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
PAIR = {"l": (0.0, 0.2, 0.0), "r": (0.0, -0.2, 0.0)}
TWO = Drive(("l",), ("r",), radius=0.1, separation=0.4)
FOUR = {"fl": (0.2, 0.3, 0.0), "fr": (0.2, -0.3, 0.0), "rl": (-0.2, 0.3, 0.0), "rr": (-0.2, -0.3, 0.0)}
ROLES = (("fl", 1, 1), ("fr", 1, -1), ("rl", -1, 1), ("rr", -1, -1))
MECANUM = Drive(driven=tuple(FOUR), radius=0.1, reach=0.5, roles=ROLES)


def found(
    drive: Drive | None,
    places: dict[str, Vector],
    axes: dict[str, Vector] | None = None,
    tasks: tuple[ControllerTask, ...] = (),
    **fields: object,
) -> list[Trouble]:
    """Return what is wrong with wheels of 0.1 m at some places; they turn about y unless other axes are given."""
    hinges = []
    for name, place in places.items():
        axis = (axes or {}).get(name, LEFT)
        made = Hinge(name, "continuous", parent="base", child=f"{name}_link", pose=Pose(place), axis=axis)
        hinges.append(made._replace(effort=20.0, velocity=20.0)._replace(**fields))  # type: ignore[arg-type]
    bodies = [LinkBody("base", 5.0), *(LinkBody(hinge.child, 0.5, radius=0.1) for hinge in hinges)]
    mechanism = Mechanism("base", {body.name: body for body in bodies}, tuple(hinges))
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, tuple(places), "velocity", drive=drive)
    return list(drive_troubles(mechanism, tasks or (task,)))


def codes(troubles: list[Trouble]) -> list[str]:
    return [trouble.code for trouble in troubles]


def only(troubles: list[Trouble]) -> str:
    [trouble] = troubles
    return f"{trouble.code}: {trouble.message}"


# -- sides and places ------------------------------------------------------------------------------------------------


def test_a_wheel_on_the_wrong_side_is_named_with_both_sides() -> None:
    places = {**PAIR, "l2": (-0.3, -0.2, 0.0), "r2": (-0.3, -0.2, 0.0)}
    assert "'l2'" in only(found(TWO._replace(left=("l", "l2"), right=("r", "r2")), places))
    assert "a left wheel" in only(found(TWO._replace(left=("l", "l2"), right=("r", "r2")), places))
    places = {**PAIR, "l2": (-0.3, 0.2, 0.0), "r2": (-0.3, 0.2, 0.0)}
    assert "on the left side" in only(found(TWO._replace(left=("l", "l2"), right=("r", "r2")), places))


@pytest.mark.parametrize(("aside", "expected"), [(0.004, []), (0.006, ["UC960"])])
def test_the_first_of_two_driven_wheels_may_be_hardly_left_of_the_second(aside: float, expected: list[str]) -> None:
    """A steering controller takes it as the right one."""
    places = {"a": (0.0, aside, 0.0), "b": (0.0, 0.0, 0.0), "s": (1.0, 0.0, 0.0)}
    drive = Drive(driven=("a", "b"), steered=("s",), radius=0.1, wheelbase=1.0)
    assert codes(found(drive, places, {"s": UP})) == expected


def test_the_wheels_of_a_mecanum_base_are_where_their_names_say() -> None:
    assert found(MECANUM, FOUR) == []
    across = {**FOUR, "fl": FOUR["rl"], "rl": FOUR["fl"]}
    assert codes(found(MECANUM, across)) == ["UC960", "UC960"]
    assert "at the rear left" in found(MECANUM, across)[0].message
    aside = {**FOUR, "fl": FOUR["fr"], "fr": FOUR["fl"]}
    assert codes(found(MECANUM, aside)) == ["UC960", "UC960"]
    assert "its front left wheel" in found(MECANUM, aside)[0].message


def test_a_mecanum_base_that_lacks_a_wheel_is_not_judged_by_their_places() -> None:
    three = {name: place for name, place in FOUR.items() if name != "fl"}
    assert "UC960" not in codes(found(MECANUM, three))


@pytest.mark.parametrize(("reach", "expected"), [(0.5, []), (0.57, []), (0.58, ["UC913"]), (0.42, ["UC913"])])
def test_the_sum_of_half_wheelbase_and_half_track_of_a_mecanum_base(reach: float, expected: list[str]) -> None:
    assert codes(found(MECANUM._replace(reach=reach), FOUR)) == expected
    assert codes(found(MECANUM._replace(reach=reach, roles=ROLES[:3]), FOUR)) == []


# -- axes ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("axis", "how"),
    [(RIGHT, "backwards"), ((0.6, -0.8, 0.0), "backwards"), (UP, "cannot roll"), ((0.8, -0.6, 0.0), "cannot roll")],
)
def test_a_wheel_that_turns_backwards_is_told_from_one_that_cannot_roll(axis: Vector, how: str) -> None:
    assert how in only(found(TWO, PAIR, {"l": axis}))


@pytest.mark.parametrize(
    ("axis", "place", "expected"),
    [
        (UP, 1.0, None),
        ((0.6, 0.0, 0.8), 1.0, None),
        (DOWN, 1.0, "to the right"),
        ((0.6, 0.0, -0.8), 1.0, "to the right"),
        (LEFT, 1.0, "cannot steer"),
        (DOWN, -1.0, None),
        (LEFT, -1.0, "cannot steer"),
        ((0.8, 0.0, -0.6), -1.0, "cannot steer"),
    ],
)
def test_a_pivot_turns_left_or_right_of_it_is_behind_the_driven_wheels(
    axis: Vector, place: float, expected: str | None
) -> None:
    drive = Drive(driven=("r", "l"), steered=("s",), radius=0.1, wheelbase=1.0)
    troubles = found(drive, {**PAIR, "s": (place, 0.0, 0.0)}, {"s": axis})
    assert codes(troubles) == (["UC961"] if expected else [])
    assert all(str(expected) in trouble.message for trouble in troubles)


AROUND = {f"w{n}": (0.3 * math.cos(n * 2.0944), 0.3 * math.sin(n * 2.0944), 0.0) for n in range(3)}
OUT = {name: (x / 0.3, y / 0.3, 0.0) for name, (x, y, _) in AROUND.items()}
OMNI = Drive(driven=tuple(AROUND), radius=0.1, arm=0.3, angles=(0.0, 2.0944, 4.1888))


def test_the_wheels_of_an_omnidirectional_base_turn_about_the_way_out() -> None:
    assert found(OMNI, AROUND, OUT) == []
    inwards = {**OUT, "w0": (-1.0, 0.0, 0.0)}
    assert "backwards" in only(found(OMNI, AROUND, inwards))
    assert "outwards" in only(found(OMNI, AROUND, {**OUT, "w0": LEFT}))
    assert codes(found(OMNI._replace(angles=(2.0944, 0.0, 4.1888)), AROUND, OUT)) == ["UC960", "UC960"]


def test_a_wheel_in_the_middle_has_no_direction_from_there() -> None:
    middle = {**AROUND, "w0": (0.001, -0.002, 0.0)}
    assert "UC960" not in codes(found(OMNI, middle, OUT))


# -- plain velocity controllers --------------------------------------------------------------------------------------


def plain(
    places: dict[str, Vector], axes: dict[str, Vector], interface: str = "velocity", **fields: object
) -> list[str]:
    task = ControllerTask("wheels", MotionFamily.FORWARD, tuple(places), interface)
    return [f"{one.code} {one.subject}" for one in found(None, places, axes, (task,), **fields)]


def test_wheels_that_turn_against_those_of_the_other_side_are_mirrored() -> None:
    assert plain(PAIR, {}) == []
    assert plain(PAIR, {"r": RIGHT}) == ["UC959 joint:r"]
    assert plain(PAIR, {"r": RIGHT}, "position") == []
    assert plain(PAIR, {"r": RIGHT}, type="revolute") == []
    [trouble] = found(
        None, PAIR, {"r": RIGHT}, (ControllerTask("wheels", MotionFamily.FORWARD, ("l", "r"), "velocity"),)
    )
    assert "'l'" in trouble.message
    three = {**PAIR, "l2": (-0.3, 0.2, 0.0)}
    assert plain(three, {"l": RIGHT, "l2": RIGHT}) == ["UC959 joint:r"]


def test_wheels_of_one_side_are_not_mirrored_sides() -> None:
    assert plain({"a": (0.0, 0.2, 0.0), "b": (0.3, 0.2, 0.0)}, {"a": RIGHT}) == []
    assert plain({"a": (0.0, -0.2, 0.0), "b": (0.3, -0.2, 0.0)}, {"a": RIGHT}) == []


@pytest.mark.parametrize(("height", "expected"), [(0.004, ["UC959 joint:r"]), (0.006, [])])
def test_a_wheel_above_the_ground_is_not_compared(height: float, expected: list[str]) -> None:
    assert plain({**PAIR, "r": (0.0, -0.2, height)}, {"r": RIGHT}) == expected


# -- speed -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("speed", "velocity", "why"),
    [(0.01, 20.0, "its own velocity limit"), (9.0, 0.1, "the velocity limits of its wheels")],
)
def test_a_base_that_is_too_slow_is_told_what_limits_it(speed: float, velocity: float, why: str) -> None:
    """A wheel of 0.1 m with 0.1 rad/s drives at 0.01 m/s."""
    assert why in only(found(TWO._replace(speed=speed), PAIR, velocity=velocity))
