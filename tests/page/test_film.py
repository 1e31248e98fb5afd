"""A film of a smoke test: each controller's motion in turn, at the speed at which it happened."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Generator
from pathlib import Path
from types import SimpleNamespace

import pytest
from smoke_robots import Arm
from smoking import smoked, target_of

from urdfctl.errors import UserError
from urdfctl.model.geometry import Pose
from urdfctl.page.film import RATE, check_film, film_of, script_of
from urdfctl.smoke.results import Curve, RobotResult

IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]
SCENE = {
    "links": {
        "base": [{"shape": "box", "size": [0.2, 0.2, 0.2], "pose": IDENTITY, "colour": None}],
        "arm": [{"shape": "box", "size": [0.6, 0.1, 0.1], "pose": IDENTITY, "colour": None}],
    },
    "joints": [
        {
            "name": "turn",
            "parent": "base",
            "child": "arm",
            "pose": IDENTITY,
            "moves": True,
            "mimic": None,
            "start": 0.0,
            "type": "revolute",
            "axis": [0, 0, 1],
            "error": False,
            "control": "position",
        }
    ],
    "meshes": [],
}


def curve(joint: str, quantity: str, measured: tuple[float, ...]) -> Curve:
    seconds = tuple((n + 1) / RATE for n in range(len(measured)))
    return Curve("mover", joint, quantity, seconds, measured, measured)


def with_curves(folder: Path, *curves: Curve) -> RobotResult:
    files = {"robot.urdf": Arm().urdf(), "controllers.yaml": Arm().yaml()}
    return smoked(target_of(folder, files), distro="jazzy")._replace(curves=curves)


def test_the_pictures_show_where_joints_and_the_base_are(tmp_path: Path) -> None:
    robot = with_curves(tmp_path, curve("turn", "position", (0.1, 0.4)), curve("base", "ahead", (0.5, 1.0)))
    pictures = list(script_of(3, robot))
    assert [(one.robot, one.positions, one.base.place) for one in pictures] == [
        (3, {"turn": 0.1}, (0.5, 0.0, 0.0)),
        (3, {"turn": 0.4}, (1.0, 0.0, 0.0)),
    ]


def test_a_film_has_a_picture_for_each_tenth_of_a_second_and_shows_the_motion(tmp_path: Path) -> None:
    image = pytest.importorskip("PIL.Image")
    pytest.importorskip("trimesh")
    robot = with_curves(tmp_path, curve("turn", "position", (0.0, 0.7, 1.4)))
    (tmp_path / "film.gif").write_bytes(film_of("film.gif", [robot], [SCENE]))
    with image.open(tmp_path / "film.gif") as film:
        assert (film.n_frames, film.size) == (3, (480, 360))
        first = film.convert("RGB").tobytes()
        film.seek(2)
        assert film.convert("RGB").tobytes() != first


def test_a_video_has_the_size_of_its_pictures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("PIL.Image")
    pytest.importorskip("trimesh")
    sizes, pictures = [], []

    def write_frames(
        path: str, size: tuple[int, int], fps: float, macro_block_size: int = 16
    ) -> Generator[None, bytes, None]:
        """Write the size, stretched as imageio-ffmpeg does it."""
        sizes.append(tuple(-(-pixels // macro_block_size) * macro_block_size for pixels in size))
        Path(path).write_bytes(b"video")
        with contextlib.suppress(GeneratorExit):
            while True:
                pictures.append((yield))

    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", SimpleNamespace(write_frames=write_frames))
    robot = with_curves(tmp_path, curve("turn", "position", (0.0, 0.7, 1.4)))
    assert film_of("film.mp4", [robot], [SCENE]) == b"video"
    assert (sizes, len(pictures), len(pictures[0])) == ([(480, 360)], 3, 480 * 360 * 3)


def test_a_film_of_nothing_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="nothing moved"):
        film_of("film.gif", [with_curves(tmp_path)], [SCENE])


def test_another_format_or_a_missing_library_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(UserError, match=r"only \.gif and \.mp4"):
        check_film("film.avi")
    monkeypatch.setattr("urdfctl.page.film.find_spec", lambda _: None)
    with pytest.raises(UserError, match=r"pip install 'urdfctl\[video\]'"):
        check_film("film.mp4")


def test_the_root_of_a_scene_is_where_the_film_puts_it() -> None:
    from urdfctl.view.image import poses_of

    poses = poses_of(SCENE["joints"], {"turn": 0.0}, Pose((2.0, 0.0, 0.0)))
    assert poses["arm"].place == (2.0, 0.0, 0.0)
