"""What a robot rests on, by geometry; whether its wheels grip; and the gears between motors and joints."""

from __future__ import annotations

import pytest

from urdfctl.model.geometry import Pose, Vector
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.shapes import Shape, Shapes
from urdfctl.smoke.statics.ground import traction_troubles
from urdfctl.smoke.statics.support import Support, support_of
from urdfctl.smoke.statics.transmissions import JointTransmission, transmission_troubles, with_transmissions
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily

CORNERS = ((0.2, 0.2), (0.2, -0.2), (-0.2, 0.2), (-0.2, -0.2))
FOOT = Shape("box", Pose((0.0, 0.0, -0.3)), (0.06, 0.06, 0.02))


def on_legs(
    *places: tuple[float, float], kind: str = "revolute", moved: tuple[str, ...] = (), own: tuple[Shape, ...] = ()
) -> Support:
    """Return what a robot of 5 kg rests on, with a leg of 0.3 m at each place and shapes of its base."""
    hinges = [
        Hinge(f"j{n}", kind, "base", f"leg{n}", Pose((x, y, 0.0)), (0.0, 1.0, 0.0), lower=-1.0, upper=1.0)
        for n, (x, y) in enumerate(places)
    ]
    bodies = {
        "base": LinkBody("base", 5.0, centre=(0.0, 0.0, 0.1)),
        **{one.child: LinkBody(one.child, 0.1) for one in hinges},
    }
    shapes = Shapes({"base": own or (Shape("box", Pose(), (0.1, 0.1, 0.1)),), **{one.child: (FOOT,) for one in hinges}})
    return support_of(Mechanism("base", bodies, tuple(hinges)), shapes, moved)


def test_a_robot_stands_on_the_feet_of_its_legs() -> None:
    assert on_legs(*CORNERS) == Support(("leg0", "leg1", "leg2", "leg3"))
    assert on_legs((0.0, 0.2), (0.0, -0.2)) == Support(("leg0", "leg1"))


def test_one_leg_is_not_a_robot_on_feet() -> None:
    assert on_legs((0.0, 0.0)).links == ()
    assert on_legs((0.0, 0.0)).why_not == "it rests on links that its controllers move"


@pytest.mark.parametrize(("moved", "links"), [((), ("base", "leg0")), (("j0",), ("base",))])
def test_a_free_wheel_carries_and_one_that_a_controller_turns_does_not(
    moved: tuple[str, ...], links: tuple[str, ...]
) -> None:
    plate = Shape("box", Pose((0.0, 0.0, -0.29)), (0.3, 0.3, 0.04))
    assert on_legs((0.3, 0.0), kind="continuous", moved=moved, own=(plate,)).links == links
    assert on_legs((0.3, 0.0), own=(plate,)).links == ("base",)


def test_a_base_on_a_ball_balances_and_one_beside_its_supports_tips() -> None:
    ball = Shape("sphere", Pose((0.0, 0.0, 0.2)), (0.5,))
    assert on_legs(own=(ball,)).why_not == "it balances on a point or a line of its base"
    aside = tuple(Shape("sphere", Pose((x, y, 0.0)), (0.05,)) for x in (0.1, 0.3) for y in (-0.1, 0.1))
    assert on_legs(own=aside).tips == "at spawn"


def test_an_arm_that_carries_more_than_its_plate_tips_it_in_some_pose() -> None:
    plate = Shapes({"base": (Shape("box", Pose(), (0.4, 0.4, 0.02)),)})
    slide = Hinge("out", "prismatic", "base", "load", Pose(), (1.0, 0.0, 0.0), lower=0.0, upper=1.0)
    for mass, tips in ((1.0, False), (5.0, True)):
        bodies = {"base": LinkBody("base", 5.0), "load": LinkBody("load", mass)}
        made = support_of(Mechanism("base", bodies, (slide,)), plate, ["out"])
        assert made.tips.startswith("with out at ") == tips
        assert made.links == ("base",)


# -- grip ------------------------------------------------------------------------------------------------------------

TWO = Drive(("l",), ("r",), radius=0.1, separation=0.4)


def slipping(grip: float | None, drag: float = 0.0) -> list[str]:
    """Return what is said of a robot of 10 kg on two wheels and a ball with some friction."""
    wheels = tuple(
        Hinge(name, "continuous", "base", f"{name}w", Pose((0.0, y, 0.0)), (0.0, 1.0, 0.0), velocity=20.0)
        for name, y in (("l", 0.2), ("r", -0.2))
    )
    ball = Hinge("b", "fixed", "base", "ball", Pose(), (0.0, 1.0, 0.0))
    bodies = {"base": LinkBody("base", 10.0), "ball": LinkBody("ball", grip=drag)}
    bodies |= {wheel.child: LinkBody(wheel.child, grip=grip) for wheel in wheels}
    contacts: dict[str, list[Vector]] = {"lw": [(0.1, 0.2, 0.0)], "rw": [(0.1, -0.2, 0.0)], "ball": [(-0.1, 0.0, 0.0)]}
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=TWO)
    found = traction_troubles(Mechanism("base", bodies, (*wheels, ball)), contacts, [task])
    return [f"{one.code} {note}" for one in found for note in (one.notes or ("",))]


def test_wheels_that_accelerate_the_robot_grip() -> None:
    """Half of 98.1 N is on the wheels; 10 kg reach 0.3 m/s in 2 s with 1.5 N, a friction of 0.03."""
    assert slipping(None) == []
    assert slipping(0.032) == []
    assert slipping(0.029) == [f"UC976 <gazebo> gives link '{name}w' the friction 0.029" for name in "lr"]


def test_a_ball_that_does_not_slide_is_dragged() -> None:
    """The ball carries the other half."""
    assert slipping(None, 0.9) == []
    assert slipping(None, 1.0) == ["UC976 link 'ball' is dragged with 49 N"]
    dragged = slipping(0.5, 0.6)
    assert dragged[0] == "UC976 link 'ball' is dragged with 29 N"
    assert len(dragged) == 3
    assert "dragged" not in " ".join(slipping(0.029, 0.01))


# -- gears -----------------------------------------------------------------------------------------------------------


def gear(
    joint: str, reduction: float, ignored_by: str = "", offset: float = 0.0, *, coupled: bool = False
) -> JointTransmission:
    return JointTransmission(joint, reduction, offset, is_coupled=coupled, ignored_by=ignored_by)


def told(*gears: JointTransmission) -> list[str]:
    tasks = [ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l", "r"), "velocity", drive=TWO)]
    return [f"{one.code} {one.subject}" for one in transmission_troubles(gears, tasks)]


@pytest.mark.parametrize(
    ("left", "right", "expected"),
    [
        (50.0, 50.0, []),
        (50.0, -50.0, []),
        (50.0, 50.4, []),
        (50.0, 51.0, ["UC974 joint:r"]),
        (51.0, 50.0, ["UC974 joint:l"]),
    ],
)
def test_the_wheels_of_a_base_have_the_same_gears(left: float, right: float, expected: list[str]) -> None:
    assert told(gear("l", left), gear("r", right)) == expected
    assert told(gear("l", left, coupled=True), gear("r", right, coupled=True)) == []


def test_a_wheel_without_a_gear_differs_from_one_that_has_one() -> None:
    assert told(gear("l", 50.0)) == ["UC974 joint:l"]
    assert told(gear("arm", 50.0)) == []


def test_a_reduction_of_0_stops_what_uses_it_and_a_negative_one_is_ignored_where_hardware_ignores_it() -> None:
    assert told(gear("arm", 0.0)) == ["UC975 joint:arm"]
    assert told(gear("arm", 0.0, "mock")) == ["UC972 robot"]
    assert told(gear("arm", 0.0, coupled=True)) == []
    assert told(gear("arm", -2.0)) == []
    assert told(gear("arm", -2.0, "mock")) == ["UC973 joint:arm", "UC972 robot"]
    assert told(gear("arm", 2.0, "mock")) == ["UC972 robot"]


@pytest.mark.parametrize(("others", "more"), [(0, ""), (1, "of 1 more joint"), (2, "of 2 more joints")])
def test_ignored_transmissions_are_one_finding(others: int, more: str) -> None:
    gears = [gear(f"j{n}", 2.0, "mock") for n in range(others + 1)]
    [trouble] = transmission_troubles(gears, [])
    assert more in trouble.message
    assert ("more joint" in trouble.message) == bool(more)
    assert "more joints" not in trouble.message or others == 2


@pytest.mark.parametrize(
    ("given", "what"),
    [
        (gear("l", 50.0), "the reduction of 50 of joint 'l' acts in the hardware"),
        (gear("l", -50.0), "the reduction of -50 of joint 'l' acts in the hardware: its motor turns the other way"),
        (gear("l", 1.0, offset=0.5), "the offset of 0.5 of joint 'l' acts in the hardware"),
        (gear("l", -1.0, coupled=True), "the coupling of joint 'l' acts in the hardware"),
        (gear("l", 50.0, "mock"), None),
        (gear("arm", 50.0), None),
    ],
)
def test_what_transmissions_do_in_the_hardware_is_named_as_not_simulated(
    given: JointTransmission, what: str | None
) -> None:
    [task] = with_transmissions([given], [ControllerTask("base", MotionFamily.FORWARD, ("l", "r"), "velocity")])
    assert task.left_out == ((("transmission", what),) if what else ())


@pytest.mark.parametrize(
    ("given", "acts"),
    [
        (gear("j", 1.0), False),
        (gear("j", 2.0), True),
        (gear("j", 1.0, offset=0.1), True),
        (gear("j", 1.0, coupled=True), True),
    ],
)
def test_a_direct_drive_is_no_gear(given: JointTransmission, acts: bool) -> None:
    assert given.acts == acts
