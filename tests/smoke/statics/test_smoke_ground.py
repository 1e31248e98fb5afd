"""How a robot comes to rest on the ground, against the plane through its feet."""

from __future__ import annotations

import math

import pytest

from urdfctl.model.geometry import Pose
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.rest_pose import rest_pose_of
from urdfctl.smoke.robot.shapes import Shape, Shapes
from urdfctl.smoke.statics.ground import ground_troubles
from urdfctl.smoke.tasks.task import ControllerTask, Drive, MotionFamily


def tripod(about: float, short: float) -> tuple[Mechanism, Shapes]:
    """Return a robot on three ball feet, 0.2 m from its middle, of which the one in a direction is too short."""
    turns = [about + n * 2 * math.pi / 3 for n in range(3)]
    feet = [
        Shape("sphere", Pose((0.2 * math.cos(turn), 0.2 * math.sin(turn), short if n == 0 else 0.0)), (0.02,))
        for n, turn in enumerate(turns)
    ]
    return Mechanism("base", {"base": LinkBody("base", 5.0, centre=(0.0, 0.0, 0.1))}, ()), Shapes({"base": tuple(feet)})


@pytest.mark.parametrize("about", [n * math.pi / 4 + 0.2 for n in range(8)])
@pytest.mark.parametrize("short", [0.01, 0.06])
def test_a_robot_leans_on_its_short_leg_whichever_that_is(about: float, short: float) -> None:
    """The plane through the feet falls by that on 1.5 times 0.2 m; one of its axes is level across the direction."""
    at_rest = rest_pose_of(*tripod(about, short))
    assert at_rest is not None
    assert at_rest.tilt == pytest.approx(math.atan2(short, 0.3), abs=0.0006)
    x, y, _ = at_rest.turn[2]
    assert math.atan2(at_rest.turn[1][0], at_rest.turn[0][0]) == pytest.approx(0.0, abs=0.03)
    assert math.cos(math.atan2(-y, -x) - about) > 0.99


def test_a_robot_that_leans_by_a_fifth_of_a_radian_has_not_tipped_over() -> None:
    wheel = Hinge("l", "continuous", parent="base", child="wheel", pose=Pose((-0.1, 0.1, 0.0)), axis=(0.0, 1.0, 0.0))
    task = ControllerTask(
        "base", MotionFamily.DIFFERENTIAL, ("l",), "velocity", drive=Drive(("l",), ("r",), radius=0.02)
    )
    for short, expected in ((0.06, []), (0.36, ["UC931"])):
        stool, shapes = tripod(0.0, short)
        robot = Mechanism("base", {**stool.bodies, "wheel": LinkBody("wheel", 0.1)}, (wheel,))
        known = Shapes({**shapes.known, "wheel": (Shape("sphere", Pose(), (0.02,)),)})
        codes = [trouble.code for trouble in ground_troubles(robot, known, [task])]
        assert [code for code in codes if code == "UC931"] == expected


@pytest.mark.parametrize(("interface", "expected"), [("effort", []), ("position", ["UC940"])])
def test_a_wheel_on_a_rocker_that_is_only_pushed_is_not_off_the_ground(interface: str, expected: list[str]) -> None:
    rocker = Hinge("rocker", "revolute", parent="base", child="arm", pose=Pose(), axis=(0.0, 1.0, 0.0))
    wheel = Hinge("l", "continuous", parent="arm", child="wheel", pose=Pose((-0.1, 0.1, 0.1)), axis=(0.0, 1.0, 0.0))
    drive = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l",), "velocity", drive=Drive(("l",), radius=0.02))
    pushing = ControllerTask("rocker", MotionFamily.FORWARD, ("rocker",), interface)
    stool, shapes = tripod(0.0, 0.0)
    bodies = {**stool.bodies, "arm": LinkBody("arm", 0.1), "wheel": LinkBody("wheel", 0.1)}
    known = Shapes({**shapes.known, "wheel": (Shape("sphere", Pose(), (0.02,)),)})
    troubles = ground_troubles(Mechanism("base", bodies, (rocker, wheel)), known, [drive, pushing])
    assert [trouble.code for trouble in troubles if trouble.code == "UC940"] == expected


def test_a_robot_that_leans_names_the_parts_that_are_mounted_too_high() -> None:
    wheel = Hinge("l", "continuous", parent="base", child="wheel", pose=Pose((0.0, 0.0, 0.0)), axis=(0.0, 1.0, 0.0))
    task = ControllerTask("base", MotionFamily.DIFFERENTIAL, ("l",), "velocity", drive=Drive(("l",), radius=0.05))
    caster = Hinge("c", "fixed", parent="base", child="caster", pose=Pose((0.2, 0.0, 0.05)), axis=(0.0, 0.0, 1.0))
    bodies = {"base": LinkBody("base", 5.0, centre=(0.1, 0.1, 0.1)), "wheel": LinkBody("wheel", 0.1)}
    robot = Mechanism("base", {**bodies, "caster": LinkBody("caster", 0.1)}, (wheel, caster))
    ball = (Shape("sphere", Pose(), (0.05,)), Shape("sphere", Pose((0.0, 0.2, 0.0)), (0.05,)))
    known = Shapes({"wheel": ball, "caster": (Shape("sphere", Pose((0.0, 0.1, 0.0)), (0.05,)),)})
    [trouble] = [one for one in ground_troubles(robot, known, [task]) if one.code == "UC986"]
    assert trouble.subject == "joint:c"
    assert trouble.notes == ("lower its <origin> by 0.05 m, or enlarge the part",)
    message = trouble.message
    assert message.startswith("the robot leans by 14 degrees at rest: the robot stands on 'caster'; ")
    assert message.endswith("'caster' is 0.05 m higher than the lowest part of the robot")


def test_a_box_touches_the_ground_with_the_four_corners_of_its_lower_side() -> None:
    """They are given from the centre of mass."""
    box = Shapes({"base": (Shape("box", Pose((0.0, 0.0, 0.1)), (0.4, 0.2, 0.1)),)})
    at_rest = rest_pose_of(Mechanism("base", {"base": LinkBody("base", 5.0, centre=(0.05, 0.0, 0.1))}, ()), box)
    assert at_rest is not None
    corners = {(round(x, 6), round(y, 6), round(z, 6)) for x, y, z in at_rest.contacts["base"]}
    assert corners == {(x, y, -0.05) for x in (0.15, -0.25) for y in (0.1, -0.1)}


def test_only_links_at_the_ground_touch_it() -> None:
    legs = {
        f"l{n}": (Shape("sphere", Pose((x, y, height)), (0.05,)),)
        for n, (x, y, height) in enumerate(
            ((0.2, 0.2, 0.0), (0.2, -0.2, 0.0), (-0.2, 0.0, 0.0), (0.0, 0.0, 0.002), (0.0, 0.1, 0.004))
        )
    }
    hinges = tuple(Hinge(f"j{name}", "fixed", "base", name, Pose(), (0.0, 1.0, 0.0)) for name in legs)
    bodies = {"base": LinkBody("base", 5.0), **{name: LinkBody(name) for name in legs}}
    at_rest = rest_pose_of(Mechanism("base", bodies, hinges), Shapes(legs))
    assert at_rest is not None
    assert set(at_rest.contacts) == {"l0", "l1", "l2", "l3"}
