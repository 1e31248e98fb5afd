"""Collision geometry that takes the same space, at spawn and with all joints at 0."""

from __future__ import annotations

import math
import random

import pytest

from urdfctl.model.geometry import Pose, of_angles
from urdfctl.smoke.robot.mechanism import Hinge, LinkBody, Mechanism
from urdfctl.smoke.robot.shapes import Shape, Shapes
from urdfctl.smoke.statics.overlaps import SHRUNK, overlap_troubles, overlapping

BOX = Shape("box", Pose(), (0.2, 0.2, 0.2))
BALL = Shape("sphere", Pose(), (0.1,))
ROD = Shape("cylinder", Pose(), (0.05, 1.0))


def chain(*places: tuple[float, float, float], **fields: object) -> Mechanism:
    """Return links l0, l1, …, each on the one before at a place, with joints j1, j2, … that turn about y."""
    hinges = [
        Hinge(f"j{n}", "revolute", parent=f"l{n - 1}", child=f"l{n}", pose=Pose(place), axis=(0.0, 1.0, 0.0))._replace(
            **{"lower": -3.0, "upper": 3.0, **fields}  # type: ignore[arg-type]
        )
        for n, place in enumerate(places, 1)
    ]
    return Mechanism("l0", {f"l{n}": LinkBody(f"l{n}") for n in range(len(places) + 1)}, tuple(hinges))


def pairs(mechanism: Mechanism, *shapes: Shape | None) -> list[tuple[str, str]]:
    known = {f"l{n}": (shape,) if shape else () for n, shape in enumerate(shapes)}
    return overlapping(mechanism, Shapes(known), mechanism.start())


@pytest.mark.parametrize(("apart", "expected"), [(0.15, [("l0", "l3")]), (0.2, []), (0.3, [])])
def test_boxes_overlap_if_one_reaches_into_the_other(apart: float, expected: list[tuple[str, str]]) -> None:
    arm = chain((0.0, 0.0, 0.5), (0.0, 0.0, 0.5), (apart, 0.0, -1.0))
    assert pairs(arm, BOX, BALL, BALL, BOX) == expected


@pytest.mark.parametrize(("shape", "apart"), [(BALL, 0.19), (ROD, 0.14), (BOX, 0.19)])
def test_each_shape_is_measured(shape: Shape, apart: float) -> None:
    away = chain((0.0, 0.0, 5.0), (0.0, 0.0, 5.0), (apart, 0.0, -10.0))
    assert pairs(away, BALL, BOX, BOX, shape) == []
    near = chain((0.0, 0.0, 5.0), (0.0, 0.0, 5.0), (apart * 0.8, 0.0, -10.0))
    assert pairs(near, BALL, BOX, BOX, shape) == [("l0", "l3")]


def test_a_rod_that_passes_a_box_at_an_angle_is_found() -> None:
    leaning = ROD._replace(pose=Pose((0.0, 0.0, 0.0), of_angles(0.0, math.pi / 4, 0.0)))
    arm = chain((0.0, 0.0, 5.0), (0.0, 0.0, 5.0), (0.3, 0.0, -9.7))
    assert pairs(arm, BOX, BALL, BALL, leaning) == [("l0", "l3")]
    assert pairs(arm, BOX, BALL, BALL, ROD) == []


def ball_beside(box: Shape, ball: Shape, way: tuple[float, float, float], apart: float) -> tuple[float, float, float]:
    """Return a place in a direction from a box where a ball is apart from it, as a part of its radius: 1 touches it.

    Both are as the algorithm sees them, shrunk.
    """
    half, radius = [size / 2 * SHRUNK for size in box.size], ball.size[0] * SHRUNK
    near, far = 0.0, 10.0
    for _ in range(50):
        middle = (near + far) / 2
        rest = [max(0.0, abs(middle * part) - most) for part, most in zip(way, half, strict=True)]
        near, far = (middle, far) if math.hypot(*rest) < apart * radius else (near, middle)
    return way[0] * near, way[1] * near, way[2] * near


@pytest.mark.parametrize(("apart", "least", "most"), [(0.6, 85, 100), (1.05, 0, 0)])
def test_balls_that_reach_far_into_boxes_are_nearly_always_found_and_those_beside_them_never(
    apart: float, least: int, most: int
) -> None:
    chance = random.Random(1)  # noqa: S311 (a sample)
    found = 0
    for _ in range(100):
        box = Shape("box", Pose(), (chance.uniform(0.05, 0.5), chance.uniform(0.05, 0.5), chance.uniform(0.05, 0.5)))
        ball = Shape("sphere", Pose(), (chance.uniform(0.02, 0.3),))
        way = (chance.gauss(0, 1), chance.gauss(0, 1), chance.gauss(0, 1))
        x, y, z = ball_beside(box, ball, way, apart)
        found += bool(pairs(chain((0.0, 0.0, 5.0), (0.0, 0.0, 5.0), (x, y, z - 10.0)), box, BALL, BALL, ball))
    assert least <= found <= most


def test_neighbours_may_overlap_also_over_one_link_between_them() -> None:
    here = (0.0, 0.0, 0.0)
    assert pairs(chain(here, here), BOX, BOX, BOX) == []
    assert pairs(chain(here, here, here), BOX, None, BOX, BOX) == []
    assert pairs(chain(here, here, here), BOX, BOX, BOX, BOX) == [("l0", "l3")]


def test_two_fingers_of_one_palm_may_not_overlap() -> None:
    fingers = [hinge._replace(parent="l0") for hinge in chain((0.0, 0.0, 0.3), (0.0, 0.1, 0.3)).hinges]
    palm = Mechanism("l0", {f"l{n}": LinkBody(f"l{n}") for n in range(3)}, tuple(fingers))
    assert pairs(palm, BOX, BOX, BOX) == [("l1", "l2")]


def folded(**fields: object) -> tuple[Mechanism, Shapes]:
    """Return an arm whose last link lies on the first at 0, and stretches out at spawn."""
    arm = chain((0.0, 0.0, 0.5), (0.0, 0.0, 0.5), (0.0, 0.0, -1.0), initial=1.5, **fields)
    return arm, Shapes({"l0": (BOX,), "l1": (BALL,), "l2": (BALL,), "l3": (BOX,)})


def test_the_pose_with_all_joints_at_0_is_looked_at_too() -> None:
    (trouble,) = overlap_troubles(*folded())
    assert (trouble.code, trouble.message) == ("UC968", "links 'l0' and 'l3' overlap with all joints at 0")


def test_a_pose_that_the_limits_forbid_is_not_looked_at() -> None:
    assert list(overlap_troubles(*folded(lower=0.5))) == []


def test_a_pair_that_the_srdf_allows_is_not_reported() -> None:
    assert list(overlap_troubles(*folded(), {frozenset({"l0", "l3"})})) == []


def test_the_links_below_a_link_without_shapes_are_carried_by_the_last_one_that_has_some() -> None:
    """A bare link between two others is skipped; what hangs on the fourth is no neighbour of the first."""
    here = (0.0, 0.0, 0.0)
    assert pairs(chain(here, here, here, here), BOX, None, None, BOX, BOX) == []
    assert pairs(chain(here, here, here, here), BOX, None, BALL, BALL, BOX) == [("l0", "l4")]


@pytest.mark.parametrize(("links", "expected"), [(60, 1), (150, 0)])
def test_a_robot_of_more_than_a_hundred_simple_links_is_not_looked_at(links: int, expected: int) -> None:
    """The last link reaches back to the first."""
    places = [*[(0.0, 0.0, 1.0)] * (links - 2), (0.0, 0.0, 2.0 - links)]
    assert len(pairs(chain(*places), *[BALL] * links)) == expected


@pytest.mark.parametrize(("x", "y"), [(0.0, 0.0), (0.3, 0.2), (0.5, 0.1), (0.05, 0.02)])
def test_thin_plates_that_lie_on_each_other_do_not_overlap(x: float, y: float) -> None:
    plate = Shape("box", Pose(), (1.0, 1.0, 0.01))
    for height, expected in ((0.01, []), (0.0, [("l0", "l3")])):
        arm = chain((0.0, 0.0, 5.0), (0.0, 0.0, 5.0), (x, y, height - 10.0))
        assert pairs(arm, plate, BALL, BALL, plate) == expected


@pytest.mark.parametrize(("more", "note"), [(1, "1 more pair of links overlap"), (2, "2 more pairs of links overlap")])
def test_a_note_counts_the_other_pairs(more: int, note: str) -> None:
    """Fingers of one palm, two and two at one place."""
    places = [(float(n // 2), 0.0, 0.3) for n in range(2 * more + 2)]
    fingers = [
        hinge._replace(parent="l0", pose=Pose(place))
        for hinge, place in zip(chain(*places).hinges, places, strict=True)
    ]
    bodies = {f"l{n}": LinkBody(f"l{n}") for n in range(2 * more + 3)}
    (trouble,) = overlap_troubles(Mechanism("l0", bodies, tuple(fingers)), Shapes(dict.fromkeys(bodies, (BOX,))))
    assert trouble.notes == (note,)


def test_a_bare_link_to_which_one_with_shapes_is_fixed_is_not_skipped() -> None:
    """The last link hangs on the fixed one by one more: it is no neighbour of the first."""
    here = (0.0, 0.0, 0.0)
    arm = chain(here, here, here)
    mount = Hinge("mount", "fixed", parent="l1", child="cover", pose=Pose(), axis=(0.0, 1.0, 0.0))
    mechanism = Mechanism("l0", {**arm.bodies, "cover": LinkBody("cover")}, (arm.hinges[0], mount, *arm.hinges[1:]))
    for cover, expected in (({"cover": (BOX,)}, [("l0", "l3")]), ({}, [])):
        shapes = Shapes({"l0": (BOX,), "l2": (BOX,), "l3": (BOX,), **cover})
        assert overlapping(mechanism, shapes, mechanism.start()) == expected
