"""The robot as plain data for the page: links with shapes and meshes, and joints."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from urdfctl.diagnostic import Diagnostic
from urdfctl.graph.parts import Graph
from urdfctl.model.geometry import Pose
from urdfctl.model.robot import Link, Robot, Tag
from urdfctl.smoke.robot import Hinge, hinges_of, numbers_of, origin_of
from urdfctl.source.disk.files import FileProblem
from urdfctl.view.joints import Wiring, described
from urdfctl.view.meshes import NotAMesh, Surface, merged, packed, read_mesh

if TYPE_CHECKING:
    from urdfctl.source.disk.files import Files

MOST_TRIANGLES = 500_000
"""A page has at most this many triangles: about 10 MB. The meshes of a robot with more are simplified."""
_DIMENSIONS = {
    "box": ("size",),
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
    "capsule": ("radius", "length"),
}
_NUMBERS = {"box": 3, "cylinder": 2, "sphere": 1, "capsule": 2}
_MARKER = 0.05
"""The size of the marker in the place of a mesh that is missing, in m."""

_Colours = Mapping[str, list[float]]
Finder = Callable[[str], str | None]


class MeshShelf:
    """The meshes of a robot: each file is read once, and has a number.

    find: returns the file of an address, or None.
    deadline: the processor time, in s, from which on no more files are read.
    """

    def __init__(self, files: Files, find: Finder, deadline: float) -> None:
        self._files, self._find, self._deadline = files, find, deadline
        self._known: dict[str, int | str] = {}
        self.meshes: list[list[Surface]] = []

    def take(self, address: str) -> int | str:
        """Return the number of the mesh with an address, or why there is none."""
        if address not in self._known:
            self._known[address] = self._taken(address)
        return self._known[address]

    def _taken(self, address: str) -> int | str:
        path = self._find(address)
        if path is None:
            return f"{address}: file not found"
        if time.process_time() > self._deadline:
            return f"{address}: not read within the time limit (--timeout)"
        try:
            data = self._files.glance(path).data
            surfaces = merged(read_mesh(data, os.path.splitext(path)[1].lower().lstrip(".")))
        except FileProblem as problem:
            return f"{address}: {problem.message}"
        except NotAMesh as error:
            return f"{address} {error}"
        self.meshes.append(surfaces)
        return len(self.meshes) - 1

    def packed(self, most: int) -> list[list[dict[str, Any]]]:
        """Return the meshes as plain data with at most about `most` triangles."""
        total = sum(len(surface.faces) for surfaces in self.meshes for surface in surfaces)
        share = min(1.0, most / total) if total else 1.0
        return [[packed(surface, share) for surface in surfaces] for surfaces in self.meshes]


def scene_of(
    robot: Robot, graph: Graph | None, findings: Sequence[Diagnostic], shelf: MeshShelf, most: int = MOST_TRIANGLES
) -> dict[str, Any]:
    """Return the scene of a robot. Links without a parent are at the origin. A joint that fits no tree is left out.

    most: about how many triangles the meshes may have.
    """
    materials = _materials(robot)
    notes: list[str] = []
    links = {}
    for link in robot.links:
        if link.name and link.name not in links:
            links[link.name] = _parts(link, materials, shelf, notes)
    wiring = Wiring(graph)
    hinges, left_out = tree_of(robot, links)
    notes += [f"joint '{name}' is left out: the links form no tree with it" for name in left_out]
    joints = [{**_joint(hinge), **described(hinge, robot, wiring, findings)} for hinge in hinges]
    return {
        "robot": robot.name or "",
        "links": links,
        "joints": joints,
        "meshes": shelf.packed(most),
        "notes": list(dict.fromkeys(notes)),
    }


def tree_of(robot: Robot, links: Mapping[str, object]) -> tuple[list[Hinge], list[str]]:
    """Return the joints as the tree branches, each chain to its end, and the names of those that fit no tree."""
    by_parent: dict[str, list[Hinge]] = {}
    children: set[str] = set()
    names: set[str] = set()
    left_out = []
    for hinge in hinges_of(robot):
        fits = {hinge.parent, hinge.child} <= links.keys() and hinge.child not in children and hinge.name not in names
        if fits:
            children.add(hinge.child)
            names.add(hinge.name)
            by_parent.setdefault(hinge.parent, []).append(hinge)
        else:
            left_out.append(hinge.name)
    ordered: list[Hinge] = []
    pending = [hinge for name in links if name not in children for hinge in by_parent.pop(name, [])][::-1]
    while pending:
        ordered.append(pending.pop())
        pending += reversed(by_parent.pop(ordered[-1].child, []))
    return ordered, [*left_out, *(hinge.name for rest in by_parent.values() for hinge in rest)]


def _joint(hinge: Hinge) -> dict[str, Any]:
    low, high = hinge.span
    return {
        "name": hinge.name,
        "type": hinge.type,
        "moves": hinge.moves,
        "parent": hinge.parent,
        "child": hinge.child,
        "pose": _numbers(hinge.pose),
        "axis": list(hinge.axis),
        "low": low,
        "high": high,
        "start": hinge.start,
        "unit": hinge.unit,
        "mimic": list(hinge.mimic) if hinge.mimic else None,
    }


def _numbers(pose: Pose) -> list[float]:
    """A pose as 12 numbers: the rotation row by row, then the place in m."""
    found = [*(part for row in pose.turn for part in row), *pose.place]
    return found if all(map(math.isfinite, found)) else [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]


# -- shapes ----------------------------------------------------------------------------------------------------------


def _parts(link: Link, materials: _Colours, shelf: MeshShelf, notes: list[str]) -> list[dict[str, Any]]:
    """The visual shapes of a link; without any that can be drawn, its collision shapes."""
    seen = _shapes(link, "visual", materials, shelf, notes)
    if any(part["shape"] != "missing" for part in seen):
        return seen
    solid = _shapes(link, "collision", materials, shelf, notes)
    return [part for part in solid if part["shape"] != "missing"] or seen or solid


def _shapes(link: Link, role: str, materials: _Colours, shelf: MeshShelf, notes: list[str]) -> list[dict[str, Any]]:
    found = []
    for tag in link.tag.named(role):
        geometry = next(tag.named("geometry"), None)
        shape = geometry.children[0] if geometry and geometry.children else None
        part = _part(shape, shelf, notes) if shape is not None else None
        if part is not None:
            found.append({**part, "pose": _numbers(origin_of(tag)), "colour": _colour_of(tag, materials)})
    return found


def _part(shape: Tag, shelf: MeshShelf, notes: list[str]) -> dict[str, Any] | None:
    if shape.name == "mesh":
        scale = list(numbers_of(shape.attributes.get("scale", "1 1 1")))
        mesh = shelf.take(shape.attributes.get("filename", ""))
        if isinstance(mesh, int):
            return {"shape": "mesh", "mesh": mesh, "size": scale}
        notes.append(mesh)
        return {"shape": "missing", "size": [_MARKER], "note": mesh}
    texts = " ".join(shape.attributes.get(name, "") for name in _DIMENSIONS.get(shape.name, ())).split()
    try:
        size = [float(text) for text in texts]
    except ValueError:
        return None
    is_usable = len(size) == _NUMBERS.get(shape.name) and all(0 < part < math.inf for part in size)
    return {"shape": shape.name, "size": size} if is_usable else None


def _materials(robot: Robot) -> dict[str, list[float]]:
    """The colours of the materials by name: of the robot, then of the visuals that define one."""
    visuals = (visual for link in robot.links for visual in link.tag.named("visual"))
    tags = [tag for tag in robot.others if tag.name == "material"]
    tags += [tag for visual in visuals for tag in visual.named("material")]
    found: dict[str, list[float]] = {}
    for tag in tags:
        colour = _colour(tag)
        if colour is not None:
            found.setdefault(tag.attributes.get("name", ""), colour)
    return found


def _colour_of(visual: Tag, materials: _Colours) -> list[float] | None:
    material = next(visual.named("material"), None)
    if material is None:
        return None
    return _colour(material) or materials.get(material.attributes.get("name", ""))


def _colour(material: Tag) -> list[float] | None:
    tag = next(material.named("color"), None)
    words = tag.attributes.get("rgba", "").split() if tag else []
    try:
        colour = [min(1.0, max(0.0, float(word))) for word in words]
    except ValueError:
        return None
    return colour if len(colour) == 4 else None  # noqa: PLR2004 (red, green, blue, opacity)
