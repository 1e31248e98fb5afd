"""The robot as a PNG, drawn by numpy: it needs neither a display nor a graphics driver."""

from __future__ import annotations

import base64
import math
import struct
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from urdfctl.model.geometry import Pose, Vector, about, minus, scaled

if TYPE_CHECKING:
    import numpy as np

    Array = np.ndarray[Any, Any]

WIDTH, HEIGHT = 1200, 900
_FINER = 2
"""The picture is drawn this many times larger, then reduced: its edges are smooth."""
_FOCUS, _YAW, _PITCH, _AWAY = 2.1, 0.7, 0.4, 1.15
"""The camera, as the page has it: focal length, angles in rad, and distance in sizes of the robot."""
_OUTLINE = 0.003
"""The outline around what has an error is this part of the picture wide."""
_SPACING = 0.7
"""Triangles are filled with points that are at most this many pixels apart."""
_AT_ONCE = 500_000
"""Points that are drawn at the same time: each needs about 100 bytes."""
_COLOURS = {
    "position": (36, 96, 196), "velocity": (14, 124, 134), "effort": (125, 90, 60), "state": (122, 75, 194),
    "mimic": (95, 127, 158), "none": (138, 146, 160), "error": (208, 43, 48), "missing": (217, 77, 191),
}  # fmt: skip
_GREY = (0.62, 0.65, 0.7)


def png(scene: Mapping[str, Any]) -> bytes:
    """Return the picture of a scene at its start, in the colours of the page, on a transparent ground."""
    import numpy as np

    width, height = WIDTH * _FINER, HEIGHT * _FINER
    pixels = _outlined(list(_pieces(scene)), width, height)
    small = pixels.reshape(HEIGHT, _FINER, WIDTH, _FINER, 4).mean(axis=(1, 3))
    covered = np.maximum(small[..., 3:], 1e-9)
    small[..., :3] /= covered
    return _encoded((np.clip(small, 0, 1) * 255).round().astype(np.uint8))


class Film:
    """The camera of a film of a scene: it stands still, so far away that the robot stays in the picture.

    width, height: of the pictures, in pixels.
    places: those of the root in the film.
    """

    def __init__(self, scene: Mapping[str, Any], width: int, height: int, places: Sequence[Vector] = ()) -> None:
        self.scene, self.width, self.height, self._places = scene, width, height, places
        self._bounds: tuple[Array, Array] | None = None

    def picture(self, positions: Mapping[str, float], base: Pose) -> Array:
        """Return the scene with joints at some positions, and its root at a pose, as rows of pixels in RGB."""
        import numpy as np

        pieces = list(_pieces(self.scene, positions, base))
        if self._bounds is None and pieces:
            triangles = np.concatenate([piece for piece, _, _ in pieces])
            moves = np.array([minus(place, base.place) for place in (base.place, *self._places)])
            low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
            self._bounds = low + moves.min(axis=0), high + moves.max(axis=0)
        drawn = _outlined(pieces, self.width, self.height, self._bounds)
        covered = drawn[..., 3:]
        pixels: Array = (np.clip(drawn[..., :3] * covered + 1 - covered, 0, 1) * 255).round().astype(np.uint8)
        return pixels


def poses_of(
    joints: Sequence[Mapping[str, Any]], positions: Mapping[str, float] = MappingProxyType({}), base: Pose | None = None
) -> dict[str, Pose]:
    """Return the poses of the links of a scene, in the frame of its root.

    positions: those of joints that are not at their start. base: the pose of the root.
    """
    roots = {joint["parent"] for joint in joints} - {joint["child"] for joint in joints}
    found: dict[str, Pose] = dict.fromkeys(roots, base or Pose())
    starts = {joint["name"]: positions.get(joint["name"], joint["start"]) for joint in joints}
    for joint in joints:
        above = found.setdefault(joint["parent"], Pose())
        here = above.then(_pose(joint["pose"]))
        if joint["moves"]:
            leader, factor, offset = joint["mimic"] or ("", 1.0, 0.0)
            place = starts[leader] * factor + offset if leader in starts else starts[joint["name"]]
            is_slide = joint["type"] == "prismatic"
            axis = tuple(joint["axis"])
            here = here.then(Pose(scaled(axis, place)) if is_slide else Pose(turn=about(axis, place)))
        found[joint["child"]] = here
    return found


def _pose(numbers: Sequence[float]) -> Pose:
    a, b, c, d, e, f, g, h, i, x, y, z = numbers
    return Pose((x, y, z), ((a, b, c), (d, e, f), (g, h, i)))


def _pieces(
    scene: Mapping[str, Any], positions: Mapping[str, float] = MappingProxyType({}), base: Pose | None = None
) -> Iterator[tuple[Array, Array, bool]]:
    """The triangles of each part in the frame of the root, its colour, and whether lint reports an error there."""
    import numpy as np

    poses, movers = poses_of(scene["joints"], positions, base), _movers(scene["joints"])
    for link, parts in scene["links"].items():
        for part in parts:
            pose = poses.get(link, base or Pose()).then(_pose(part["pose"]))
            joint = movers.get(link)
            for corners, faces, own in _surfaces(part, scene["meshes"]):
                placed = corners @ np.array(pose.turn).T + np.array(pose.place)
                colour = _tint(part, joint, part["colour"] or own or _GREY)
                yield placed[faces], colour, joint is not None and bool(joint["error"])


def _movers(joints: Sequence[Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    """For each link the nearest joint above it that moves."""
    found: dict[str, Mapping[str, Any]] = {}
    for joint in joints:
        if joint["moves"]:
            found[joint["child"]] = joint
        elif joint["parent"] in found:
            found[joint["child"]] = found[joint["parent"]]
    return found


def _tint(part: Mapping[str, Any], joint: Mapping[str, Any] | None, own: Sequence[float]) -> Array:
    import numpy as np

    brightness = 0.3 * own[0] + 0.6 * own[1] + 0.1 * own[2]
    if part["shape"] != "missing" and joint is None:  # half as strong: a red part must not look like a fault
        return 0.45 * np.array(own[:3], float) + 0.55 * (0.25 + 0.6 * brightness)
    kind = "missing" if joint is None or part["shape"] == "missing" else joint["control"]
    return 0.8 * np.array(_COLOURS[kind]) / 255 + 0.2 * brightness


def _surfaces(part: Mapping[str, Any], meshes: Sequence[Any]) -> Iterator[tuple[Array, Array, Any]]:
    import numpy as np

    size = part["size"]
    creation: Any = import_module("trimesh.creation")
    if part["shape"] == "mesh":
        for packed in meshes[part["mesh"]]:
            corners = np.frombuffer(base64.b64decode(packed["corners"]), "<u2").reshape(-1, 3)
            faces = np.frombuffer(base64.b64decode(packed["faces"]), "<u4" if packed["wide"] else "<u2").reshape(-1, 3)
            yield (np.array(packed["low"]) + corners / 65535 * packed["size"]) * size, faces, packed["colour"]
        return
    makers: dict[str, Callable[[], Any]] = {
        "box": lambda: creation.box(extents=size),
        "cylinder": lambda: creation.cylinder(radius=size[0], height=size[1], sections=48),
        "sphere": lambda: creation.icosphere(subdivisions=3, radius=size[0]),
        "capsule": lambda: creation.capsule(radius=size[0], height=size[1]),
        "missing": lambda: creation.icosphere(subdivisions=0, radius=size[0]),
    }
    made = makers[part["shape"]]()
    middle = made.bounds.mean(axis=0)
    yield np.asarray(made.vertices) - middle, np.asarray(made.faces), None


# -- drawing ---------------------------------------------------------------------------------------------------------


def _outlined(
    pieces: Sequence[tuple[Array, Array, bool]], width: int, height: int, bounds: tuple[Array, Array] | None = None
) -> Array:
    """The parts as `_drawn` gives them, those with an error in an outline. bounds: as there."""
    import numpy as np

    pieces = [piece for piece in pieces if len(piece[0])]
    if not pieces:
        return np.zeros((height, width, 4))
    triangles = np.concatenate([piece for piece, _, _ in pieces])
    colours = np.concatenate([np.tile(colour, (len(piece), 1)) for piece, colour, _ in pieces])
    bounds = bounds or (triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1)))
    pixels = _drawn(triangles, colours, width, height, bounds)
    wrong = [piece for piece, _, is_wrong in pieces if is_wrong]
    if wrong:
        marked = np.concatenate(wrong)
        covered = _drawn(marked, np.zeros((len(marked), 3)), width, height, bounds)[..., 3] > 0
        around = covered.copy()
        thick = max(2, round(_OUTLINE * min(width, height)))
        for shift, axis in ((step, axis) for axis in (0, 1) for step in (-1, 1)):
            for _ in range(thick):
                around |= np.roll(around, shift, axis)
        pixels[around & ~covered] = [*np.array(_COLOURS["error"]) / 255, 1.0]
    return pixels


def _drawn(
    triangles: Array, colours: Array, width: int, height: int, bounds: tuple[Array, Array] | None = None
) -> Array:
    """The triangles in perspective, lit from the camera and from above, as red, green, blue and cover from 0 to 1.

    bounds: the corners of the box on which the camera looks; by default that of the triangles.
    """
    import numpy as np

    back = np.array([math.cos(_PITCH) * math.cos(_YAW), math.cos(_PITCH) * math.sin(_YAW), math.sin(_PITCH)])
    right = np.array([-math.sin(_YAW), math.cos(_YAW), 0.0])
    low, high = bounds or (triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1)))
    eye = (low + high) / 2 + _AWAY * max(0.05, float(np.linalg.norm(high - low))) * back
    seen = (triangles - eye) @ np.stack([right, np.cross(back, right), -back], axis=1)
    depth = np.maximum(seen[..., 2], 1e-6)
    half = min(width, height) / 2
    x = width / 2 + _FOCUS * half * seen[..., 0] / depth
    y = height / 2 - _FOCUS * half * seen[..., 1] / depth
    lit = np.clip(colours * _light(triangles, eye)[:, None], 0, 1)
    nearest = np.full(width * height, np.inf)
    pixels = np.zeros((width * height, 4))
    for index, weights in _filled(x, y):
        column, row = (np.rint(values[index] @ weights.T).astype(np.int64) for values in (x, y))
        away = depth[index] @ weights.T
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        place, away = (row * width + column)[inside], away[inside]
        owner = np.broadcast_to(index[:, None], inside.shape)[inside]
        np.minimum.at(nearest, place, away)
        front = away <= nearest[place]
        pixels[place[front], :3] = lit[owner[front]]
        pixels[place[front], 3] = 1.0
    return pixels.reshape(height, width, 4)


def _light(triangles: Array, eye: Array) -> Array:
    import numpy as np

    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    ways = eye - triangles.mean(axis=1)
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    facing = (normals * ways).sum(axis=1)
    normals *= np.where(facing < 0, -1.0, 1.0)[:, None]
    lamp = np.array([0.4, -0.5, 1.0]) / np.linalg.norm([0.4, -0.5, 1.0])
    light: Array = 0.35 + 0.45 * np.abs(facing) + 0.25 * np.maximum(normals @ lamp, 0.0)
    return light


def _filled(x: Array, y: Array) -> Iterator[tuple[Array, Array]]:
    """Triangles of about one size, and the weights of their corners at the points that fill them."""
    import numpy as np

    around = [1, 2, 0]
    longest = np.hypot(x - x[:, around], y - y[:, around]).max(axis=1)
    parts = 2 ** np.ceil(np.log2(np.clip(longest / _SPACING, 1, 4096))).astype(np.int64)
    for number in np.unique(parts):
        of_size = np.flatnonzero(parts == number)
        for weights in _weights(int(number)):
            for chunk in np.array_split(of_size, math.ceil(len(of_size) * len(weights) / _AT_ONCE)):
                yield chunk, weights


def _weights(number: int) -> Iterator[Array]:
    """The weights of the corners at the points of a triangle that is divided into `number` rows."""
    import numpy as np

    at_once = max(1, _AT_ONCE // (number + 1))
    for start in range(0, number + 1, at_once):
        rows = np.arange(start, min(start + at_once, number + 1))
        first, second = np.meshgrid(rows, np.arange(number + 1 - start), indexing="ij")
        kept = first + second <= number
        a, b = first[kept] / number, second[kept] / number
        yield np.stack([a, b, 1 - a - b], axis=1)


def _encoded(pixels: Array) -> bytes:
    """Pixels of red, green, blue and opacity as PNG."""
    height, width = pixels.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    head = struct.pack(">II", width, height) + bytes((8, 6, 0, 0, 0))
    chunks = [(b"IHDR", head), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")]
    packed = [
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(packed)
