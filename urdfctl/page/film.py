"""The motions of a smoke test as a film: an animated GIF, or MP4."""

from __future__ import annotations

import io
import os
from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from urdfctl.errors import UserError
from urdfctl.model.geometry import Pose, about
from urdfctl.output.printing import visible
from urdfctl.page.chart import replay_of
from urdfctl.smoke.results import Curve, RobotResult
from urdfctl.startup.records import NamedTuple
from urdfctl.view.image import Film
from urdfctl.view.meshes import installed

if TYPE_CHECKING:
    import numpy as np

    Picture = np.ndarray[Any, Any]

WIDTH, HEIGHT = 480, 360
RATE = 10
"""Pictures in a second."""
MACRO_BLOCK = 8
"""What width and height are multiples of, in pixels: imageio-ffmpeg stretches other pictures, with a warning."""
MOST_PICTURES = 400
"""A film of more is shown faster."""
_LIBRARIES = {".gif": "PIL", ".mp4": "imageio_ffmpeg"}


class Scene(NamedTuple):
    """What one picture shows: a robot with joints at some positions, and what is written below.

    robot: the number of the robot.
    base: the pose of its root.
    """

    robot: int
    positions: Mapping[str, float]
    base: Pose
    caption: str


def check_film(path: str) -> None:
    """Raise UserError if a film with this name cannot be made: another format, or a library that is missing."""
    ending = os.path.splitext(path)[1].lower()
    if ending not in _LIBRARIES:
        raise UserError(f"'{path}' is no film: only .gif and .mp4 can be written")
    if not installed() or find_spec(_LIBRARIES[ending]) is None:
        raise UserError(f"the libraries that make {ending} films are not installed: pip install 'urdfctl[video]'")


def film_of(path: str, robots: Sequence[RobotResult], scenes: Sequence[Mapping[str, Any] | None]) -> bytes:
    """Return the film of some tests, in the format that the name of its file tells.

    scenes: of the robots, as the page shows them; None where there is none.
    Raises UserError if nothing moved.
    """
    shown = [n for n, scene in enumerate(scenes) if scene is not None]
    script = [one for n in shown for one in script_of(n, robots[n])]
    if not script:
        raise UserError("nothing moved that a film could show")
    script = script[:: -(-len(script) // MOST_PICTURES)]
    places = {n: [one.base.place for one in script if one.robot == n] for n in shown}
    films = {n: Film(scene, WIDTH, HEIGHT, places[n]) for n in shown if (scene := scenes[n]) is not None}
    pictures = (_captioned(films[one.robot].picture(one.positions, one.base), one.caption) for one in script)
    return _gif(pictures) if path.lower().endswith(".gif") else _mp4(pictures)


def script_of(number: int, robot: RobotResult) -> Iterator[Scene]:
    """Yield what the pictures of a robot's test show: one controller after the other."""
    verdicts = {result.name: result for result in robot.controllers}
    for controller in dict.fromkeys(curve.controller for curve in robot.curves):
        curves = [curve for curve in robot.curves if curve.controller == controller]
        result = verdicts.get(controller)
        caption = visible(f"{controller}: {result.verdict.value}" if result else controller)
        end = max((curve.seconds[-1] for curve in curves if curve.seconds), default=0.0)
        for picture in range(round(end * RATE)):
            second = (picture + 1) / RATE
            yield Scene(number, _positions(curves, second), _base(curves, second), caption)


def _positions(curves: Sequence[Curve], second: float) -> dict[str, float]:
    """Where the joints of some curves are at a time."""
    replays = (replay_of(curve) for curve in curves if curve.joint != "base")
    return {one["joint"]: _at(one["seconds"], one["positions"], second) for one in replays if one}


def _base(curves: Sequence[Curve], second: float) -> Pose:
    """Where the base is at a time: it drives ahead, then turns on the spot."""
    values = {c.quantity: _at(c.seconds, c.measured, second) for c in curves if c.joint == "base" and c.seconds}
    return Pose((values.get("ahead", 0.0), 0.0, 0.0), about((0.0, 0.0, 1.0), values.get("yaw", 0.0)))


def _at(seconds: Sequence[float], values: Sequence[float], second: float) -> float:
    return values[min(bisect_left(seconds, second), len(values) - 1)] if values else 0.0


# -- formats ---------------------------------------------------------------------------------------------------------


def _captioned(picture: Picture, caption: str) -> Picture:
    """A picture with words in its corner, if the library that draws them is there."""
    if find_spec("PIL") is None:
        return picture
    import numpy as np

    image = import_module("PIL.Image").fromarray(picture)
    import_module("PIL.ImageDraw").Draw(image).text((8, HEIGHT - 20), caption, fill=(40, 40, 40))
    return np.asarray(image)


def _gif(pictures: Iterator[Picture]) -> bytes:
    image: Any = import_module("PIL.Image")
    first, *others = (image.fromarray(picture) for picture in pictures)
    data = io.BytesIO()
    first.save(data, "GIF", save_all=True, append_images=others, duration=1000 // RATE, loop=0)
    return data.getvalue()


def _mp4(pictures: Iterator[Picture]) -> bytes:
    from urdfctl.output.scratch import scratch_folder
    from urdfctl.source.disk.files import Files

    library: Any = import_module("imageio_ffmpeg")
    with scratch_folder() as folder:
        path = os.path.join(folder, "film.mp4")
        writer = library.write_frames(path, (WIDTH, HEIGHT), fps=RATE, macro_block_size=MACRO_BLOCK)
        writer.send(None)
        for picture in pictures:
            writer.send(picture.tobytes())
        writer.close()
        return Files().glance(path).data
