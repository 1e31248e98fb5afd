"""Read meshes, and pack their triangles into few bytes.

numpy and trimesh are imported where they are used: they belong to the extra `view`.
"""

from __future__ import annotations

import base64
import contextlib
import io
import warnings
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from urdfctl.smoke.robot import is_endless
from urdfctl.startup.records import NamedTuple

if TYPE_CHECKING:
    import numpy as np

    Array = np.ndarray[Any, Any]

MESHES = ("stl", "obj", "dae")
"""The kinds of mesh files that ROS shows, by the ends of their names."""
_FINEST = 65535
"""Corners are rounded to this fraction of the mesh's size: two bytes for each coordinate."""
_COARSEST = 8
_LEAST_TRIANGLES = 500
"""No mesh is simplified below this many triangles."""


class NotAMesh(Exception):
    """A file cannot be read as a mesh; the text says why."""


class Surface(NamedTuple):
    """A part of a mesh with one colour.

    points: its corners in m, (n, 3).
    faces: the indices of the corners of its triangles, (m, 3).
    colour: red, green, blue and opacity from 0 to 1; None if the file gives none.
    """

    points: Array
    faces: Array
    colour: tuple[float, ...] | None


def installed() -> bool:
    """Return whether the libraries of the extra `view` are installed."""
    return all(find_spec(name) is not None for name in ("trimesh", "collada", "numpy"))


def read_mesh(data: bytes, kind: str) -> list[Surface]:
    """Return the surfaces of a mesh file, placed as RViz and Gazebo do: in metres, without turning its up axis.

    kind: one of MESHES. Raises NotAMesh if the file cannot be read, or has no triangles.
    """
    if data.startswith(b"version https://git-lfs"):
        raise NotAMesh("is a pointer of Git LFS; run: git lfs pull")
    if kind not in MESHES:
        raise NotAMesh(f"'.{kind}' is not a kind of mesh that ROS shows ({', '.join(MESHES)})")
    if not installed():
        raise NotAMesh("is left out: pip install 'urdfctl[view]' brings the libraries that read meshes")
    import trimesh

    if is_endless(data, kind):  # the library would unfold them all
        raise NotAMesh("cannot be read as DAE: its nodes show more nodes than a mesh has")
    try:
        with warnings.catch_warnings(), contextlib.redirect_stderr(io.StringIO()):
            warnings.simplefilter("ignore")
            scene = trimesh.load_scene(io.BytesIO(data), file_type=kind, process=False)
            surfaces = list(_surfaces(scene))
    except MemoryError:
        raise
    except Exception as error:  # noqa: BLE001 (a reader of hostile files: whatever it raises is about the file)
        raise NotAMesh(f"cannot be read as {kind.upper()}: {_first_line(error)}") from None
    if not surfaces:
        raise NotAMesh(f"has no triangles that can be read as {kind.upper()}")
    return surfaces


def _first_line(error: Exception) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0][:120]


def _surfaces(scene: Any) -> Iterator[Surface]:
    import numpy as np

    for name in scene.graph.nodes_geometry:
        turn, key = scene.graph[name]
        geometry = scene.geometry[key]
        faces = getattr(geometry, "faces", None)
        if faces is None or len(faces) == 0:
            continue
        points = np.asarray(geometry.vertices, float) @ turn[:3, :3].T + turn[:3, 3]
        if not np.isfinite(points).all():
            raise NotAMesh("has corners that are not finite numbers")
        yield Surface(points * _metres(geometry), np.asarray(faces, np.int64), _colour(geometry))


def _metres(geometry: Any) -> float:
    """The unit of a COLLADA file in m; the other kinds have none. trimesh names it, such as `0.01 * meters`."""
    factor, mark, _ = str(geometry.metadata.get("units", "")).partition(" * meters")
    return float(factor) if mark else 1.0


def _colour(geometry: Any) -> tuple[float, ...] | None:
    visual = geometry.visual
    material = getattr(visual, "material", None)
    if material is None and not getattr(visual, "defined", False):
        return None
    colour = getattr(material, "main_color", None) if material is not None else visual.main_color
    return None if colour is None else tuple(round(float(part) / 255, 3) for part in colour)


def merged(surfaces: Sequence[Surface]) -> list[Surface]:
    """Return surfaces with those of one colour as one."""
    import numpy as np

    by_colour: dict[tuple[float, ...] | None, list[Surface]] = {}
    for surface in surfaces:
        by_colour.setdefault(surface.colour, []).append(surface)
    found = []
    for colour, parts in by_colour.items():
        starts = np.cumsum([0, *(len(part.points) for part in parts[:-1])])
        faces = np.concatenate([part.faces + start for part, start in zip(parts, starts, strict=True)])
        found.append(Surface(np.concatenate([part.points for part in parts]), faces, colour))
    return found


def packed(surface: Surface, share: float) -> dict[str, Any]:
    """Return a surface as plain data: corners as fractions of its box in 16 bits, and indices, both in base64.

    share: the fraction of its triangles to keep. Corners that are close then become one.
    """
    low, high = surface.points.min(axis=0), surface.points.max(axis=0)
    most = max(_LEAST_TRIANGLES, int(len(surface.faces) * share))
    cells = _FINEST
    corners, faces = _rounded(surface, low, high, cells)
    if len(faces) > most:
        cells = 1024
        while cells > _COARSEST and len(faces) > most:
            corners, faces = _rounded(surface, low, high, cells)
            cells = int(cells / 1.5)
    wide = len(corners) > _FINEST
    return {
        "low": low.tolist(),
        "size": (high - low).tolist(),
        "corners": _base64(corners.astype("<u2")),
        "faces": _base64(faces.astype("<u4" if wide else "<u2")),
        "wide": bool(wide),
        "triangles": len(faces),
        "colour": list(surface.colour) if surface.colour else None,
    }


def _rounded(surface: Surface, low: Array, high: Array, cells: int) -> tuple[Array, Array]:
    """The corners of a surface rounded to a grid of cubes, as 16-bit fractions of its box, and its triangles."""
    import numpy as np

    size = high - low
    largest = float(size.max()) or 1.0
    steps = np.maximum(1, np.round(cells * size / largest)) if cells < _FINEST else np.full(3, _FINEST)
    fractions = (surface.points - low) / np.where(size > 0, size, 1.0)
    cell = np.round(fractions * steps).astype(np.int64)
    key = (cell[:, 0] << 34) | (cell[:, 1] << 17) | cell[:, 2]
    _, first, inverse = np.unique(key, return_index=True, return_inverse=True)
    faces = inverse.reshape(-1)[surface.faces]
    faces = faces[(faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])]
    if cells < _FINEST:
        _, kept = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
        faces = faces[np.sort(kept)]
    return np.round(cell[first] / steps * _FINEST), faces


def _base64(values: Array) -> str:
    return base64.b64encode(values.tobytes()).decode("ascii")
