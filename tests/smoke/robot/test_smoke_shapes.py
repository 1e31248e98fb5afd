"""Collision shapes in numbers: the wheels that they form, and the corners of meshes as far as they are read."""

from __future__ import annotations

import math
import random
import struct
from pathlib import Path

import pytest

from urdfctl.model.geometry import Pose, Vector, of_angles
from urdfctl.smoke.robot.shapes import MOST_POINTS, Shape, corners_of, rim_of

LEFT = (0.0, 1.0, 0.0)
TRIANGLE = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 2.0, 0.0))


def test_the_wheel_of_a_link_is_the_largest_of_its_shapes() -> None:
    hub, tyre = Shape("sphere", Pose(), (0.05,)), Shape("sphere", Pose((0.0, 0.01, 0.0)), (0.1,))
    for shapes in ((hub, tyre), (tyre, hub)):
        rim = rim_of(shapes, LEFT)
        assert rim is not None
        assert (rim.radius, rim.place) == pytest.approx((0.1, 0.01))
    assert rim_of((), LEFT) is None


@pytest.mark.parametrize("turn", [n * math.pi / 14 for n in range(7)])
def test_the_rim_of_a_roller_aside_reaches_its_far_side(turn: float) -> None:
    """Its axis is 0.1 m from the wheel's, parallel to it, and its radius 0.05 m."""
    place = (0.1 * math.cos(turn), 0.0, 0.1 * math.sin(turn))
    rim = rim_of((Shape("cylinder", Pose(place, of_angles(math.pi / 2, 0, 0)), (0.05, 0.04)),), LEFT)
    assert rim is not None
    assert rim.radius == pytest.approx(0.15, rel=0.005)


@pytest.mark.parametrize(
    ("shape", "volume"),
    [
        (Shape("box", Pose(), (0.1, 0.2, 0.3)), 0.006),
        (Shape("cylinder", Pose(), (0.1, 0.5)), 0.5 * math.pi * 0.01),
        (Shape("sphere", Pose(), (0.3,)), 4 / 3 * math.pi * 0.027),
        (Shape("mesh", Pose(), (), ((0.0, 0.0, 0.0), (0.1, 0.0, -0.3), (0.0, 0.2, 0.0))), 0.006),
    ],
)
def test_the_volume_of_a_shape_is_that_of_the_textbook_and_of_a_mesh_that_of_its_box(
    shape: Shape, volume: float
) -> None:
    assert shape.volume == pytest.approx(volume)


# -- meshes ----------------------------------------------------------------------------------------------------------


def obj(path: Path, points: list[Vector], comment: str = "") -> tuple[Vector, ...]:
    path.write_text("".join(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points) + comment, encoding="utf-8")
    return corners_of(str(path))


def ball(count: int) -> list[Vector]:
    """Return points on a ball of 1 m, spread by chance."""
    chance = random.Random(1)  # noqa: S311 (a sample)
    points = []
    for _ in range(count):
        x, y, z = (chance.gauss(0, 1) for _ in range(3))
        size = math.sqrt(x * x + y * y + z * z)
        points.append((x / size, y / size, z / size))
    return points


@pytest.mark.parametrize(("count", "whole"), [(1500, True), (3000, False)])
def test_a_mesh_of_two_thousand_corners_is_used_whole_and_a_larger_one_is_thinned(
    count: int, whole: bool, tmp_path: Path
) -> None:
    assert (len(obj(tmp_path / "ball.obj", ball(count))) == count) == whole


def test_a_thinned_ball_is_still_round_and_has_some_hundred_corners(tmp_path: Path) -> None:
    corners = obj(tmp_path / "ball.obj", ball(4000))
    assert len(corners) < 500
    for x, y, z in ball(50):
        assert max(x * a + y * b + z * c for a, b, c in corners) > 0.95


def test_a_thinned_mesh_keeps_what_lies_farthest_out(tmp_path: Path) -> None:
    """Not only along the axes."""
    inner = [(0.8 * x, 0.8 * y, 0.8 * z) for x, y, z in ball(4000)]
    spike = (0.6, 0.6, 0.6)
    for points in ([spike, *inner], [*inner, spike]):
        assert spike in obj(tmp_path / "ball.obj", points)


@pytest.mark.parametrize(("megabytes", "expected"), [(4, 3), (6, 0)])
def test_a_mesh_of_more_than_five_megabytes_is_not_read(megabytes: int, expected: int, tmp_path: Path) -> None:
    comment = "# " + "x" * (megabytes << 20)
    assert len(obj(tmp_path / "part.obj", list(TRIANGLE), comment)) == expected


def binary_stl(header: bytes) -> bytes:
    return header.ljust(80) + struct.pack("<I12fH", 1, 0, 0, 1, *(part for corner in TRIANGLE for part in corner), 0)


ASCII_STL = "solid part\n facet normal 0 0 1\n  outer loop\n" + "".join(
    f"   vertex {x} {y} {z}\n" for x, y, z in TRIANGLE
)


@pytest.mark.parametrize(
    "data",
    [ASCII_STL.encode(), binary_stl(b"made by a scanner"), binary_stl(b"solid part"), binary_stl(b"a facet")],
    ids=["text", "binary", "binary that begins with solid", "binary that names a facet"],
)
def test_the_corners_of_an_stl_file_are_read_from_text_or_binary(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_bytes(data)
    assert corners_of(str(tmp_path / "part.stl")) == TRIANGLE


def test_an_stl_file_that_ends_too_early_has_no_corners(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_bytes(binary_stl(b"")[:-1])
    assert corners_of(str(tmp_path / "part.stl")) == ()


def test_the_corners_of_a_scanned_mesh_are_thinned_to_those_that_lie_farthest_out(tmp_path: Path) -> None:
    wheel = tmp_path / "wheel.obj"
    turns = [math.radians(n / 10) for n in range(3600)]
    rims = [(r * math.cos(a), y, r * math.sin(a)) for a in turns for y in (-0.02, 0.02) for r in (0.05, 0.1)]
    wheel.write_text("".join(f"v {x:.6f} {y} {z:.6f}\n" for x, y, z in rims), encoding="utf-8")
    corners = corners_of(str(wheel))
    assert len(corners) < MOST_POINTS < len(rims)
    rim = rim_of((Shape("mesh", Pose(), (), corners),), (0.0, 1.0, 0.0))
    assert rim is not None
    assert (rim.radius, rim.place, rim.width) == pytest.approx((0.1, 0.0, 0.04), abs=1e-5)
