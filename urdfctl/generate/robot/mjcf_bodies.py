"""The bodies of a robot in MuJoCo's own format: links, inertia, joints, geometry and meshes.

Poses and inertias are written with all digits, so that both formats describe the same mechanism.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Sequence

from urdfctl.generate.robot.facts import JointFacts, Skeleton
from urdfctl.generate.robot.frames import axis_of, geometries_of, number_of, origin_of, outwards, root_of
from urdfctl.generate.robot.inertia_repair import nearest_valid
from urdfctl.generate.text.scalars import xml_text
from urdfctl.model.geometry import Pose, Rotation, Vector, product, transposed
from urdfctl.model.robot import Geometry, Joint, Link, Robot, Tag
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import admits, size_of
from urdfctl.startup.records import NamedTuple

MeshPath = Callable[[str], str | None]
Surface = tuple[Sequence[Vector], Sequence[tuple[int, int, int]]]
SurfaceOf = Callable[[str], Surface]
"""Returns the corners of the COLLADA mesh in a file, in m, and those of each triangle; none if it cannot be read."""
_TYPES = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide"}
_MESHES = (".stl", ".obj", ".msh")
_MOST_TRIANGLES = 200_000
_MOST_WRITTEN = 50_000
"""Meshes with more triangles are not written into the model."""
_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_ROUNDING, _NOTICED = 1e-9, 1e-6
"""The part by which two moments must exceed the third one in MuJoCo, and what is told, as a part of the greatest."""
_TINY = 1e-9
"""The mass, in kg, and inertia, in kg m2, of moving links that have none: MuJoCo requires some."""


class _Link(NamedTuple):
    """A link with the joint above it."""

    name: str
    joint: Joint | None
    link: Link | None


class _BodyWriter:
    """Writes the bodies of one robot, and collects its meshes and what was left out."""

    def __init__(
        self, robot: Robot, joints: Sequence[JointFacts], mesh_path: MeshPath, surface_of: SurfaceOf | None
    ) -> None:
        self._facts = {joint.name: joint for joint in joints}
        self._mesh_path, self._surface_of = mesh_path, surface_of
        self._surfaces: dict[str, Surface] = {}
        self._meshes: dict[tuple[str, str], str] = {}
        self.notes: dict[str, None] = {}
        links = {link.name: link for link in robot.links if link.name}
        self._below: dict[str, list[_Link]] = {}
        for joint, parent, child in outwards(robot):
            self._below.setdefault(parent, []).append(_Link(child, joint, links.get(child)))
        root = root_of(robot) or "base_link"
        self._root = _Link(root, None, links.get(root))

    def bodies(self, *, free: bool) -> list[str]:
        """Return the lines of the world's body. A link called world is the world itself."""
        if self._root.name == "world":
            return [line for below in self._below.get("world", ()) for line in self._body(below, "    ")]
        return list(self._body(self._root, "    ", free=free))

    def _body(self, one: _Link, indent: str, *, free: bool = False) -> Iterator[str]:
        frame = _origin(one.joint.tag) if one.joint else Pose()
        yield f'{indent}<body name="{xml_text(one.name)}"{_pose(frame)}>'
        inside = f"{indent}  "
        if free:
            yield f'{inside}<freejoint name="floating_base_joint"/>'
        moves = free
        if one.joint and one.joint.type in _TYPES:
            moves = True
            yield inside + self._joint(one.joint)
        elif one.joint and one.joint.type not in ("fixed", None):
            self.notes[f"joint '{one.joint.name}' is fixed: MuJoCo has no '{one.joint.type}' joint"] = None
        inertial, repaired = _inertial(one.link, moves=moves)
        if repaired:
            self.notes[
                f"the inertia of link '{one.name}' is impossible for a solid; the nearest possible one is taken"
            ] = None
        if inertial:
            yield inside + inertial
        for geometry, tag in geometries_of(one.link):
            line = self._geom(one.name, geometry, tag)
            if line:
                yield inside + line
        for below in self._below.get(one.name, ()):
            yield from self._body(below, inside)
        yield f"{indent}</body>"

    def _joint(self, joint: Joint) -> str:
        name = joint.name or ""
        facts = self._facts.get(name) or JointFacts(name)
        x, y, z = axis_of(joint, Pose())
        text = f'<joint name="{xml_text(name)}" type="{_TYPES[joint.type or ""]}" axis="{x!r} {y!r} {z!r}"'
        if facts.lower is not None and facts.upper is not None and facts.lower < facts.upper:
            text += f' range="{float(facts.lower)!r} {float(facts.upper)!r}"'
        if facts.effort:
            text += f' actuatorfrcrange="{-float(facts.effort)!r} {float(facts.effort)!r}"'
        text += f' damping="{facts.damping!r}"' if facts.damping else ""
        return text + (f' frictionloss="{facts.friction!r}"' if facts.friction else "") + "/>"

    def _geom(self, link: str, geometry: Geometry, tag: Tag) -> str | None:
        if geometry.shape is None:
            return None
        collides = geometry.role == "collision"
        frame = _origin(tag)
        shape = self._shape(link, geometry.shape)
        if shape is None:
            return None
        group = 'group="3"' if collides else 'group="2" contype="0" conaffinity="0"'
        return f'<geom {shape} mass="0" {group}{_pose(frame)}/>'

    def _shape(self, link: str, shape: Tag) -> str | None:
        if shape.name == "mesh":
            return self._mesh(link, shape)
        numbers = {
            name: [number_of(word) for word in shape.attributes.get(name, "").split()]
            for name in ("size", "radius", "length")
        }
        flat = [value for values in numbers.values() for value in values]
        if not flat or any(not value or value <= 0 for value in flat):
            self.notes[f"a {shape.name} of link '{link}' has no size"] = None
            return None
        sizes = {name: [value or 0.0 for value in values] for name, values in numbers.items()}
        if shape.name == "box":
            return f'type="box" size="{" ".join(repr(value / 2) for value in sizes["size"])}"'
        if shape.name == "sphere":
            return f'type="sphere" size="{sizes["radius"][0]!r}"'
        if shape.name in ("cylinder", "capsule"):
            return f'type="{shape.name}" size="{sizes["radius"][0]!r} {sizes["length"][0] / 2!r}"'
        return None

    def _mesh(self, link: str, shape: Tag) -> str | None:
        address, scale = shape.attributes.get("filename", ""), shape.attributes.get("scale", "1 1 1")
        path = self._mesh_path(address)
        why = self._fault(path) if path else "was not found"
        if why or path is None:
            self.notes[f"mesh '{address}' of link '{link}' is left out: it {why}"] = None
            return None
        name = self._meshes.get((path, scale))
        if name is None:
            stem = os.path.splitext(os.path.basename(path))[0]
            taken = set(self._meshes.values())
            name = next(each for n in range(len(taken) + 1) if (each := f"{stem}_{n}" if n else stem) not in taken)
            self._meshes[path, scale] = name
        return f'type="mesh" mesh="{xml_text(name)}"'

    def _fault(self, path: str) -> str:
        """Why a mesh is left out; empty if MuJoCo reads its file, or if its surface is written into the model."""
        if self._surface_of is None or not path.lower().endswith(".dae") or not admits(path):
            return _mesh_fault(path)
        if path not in self._surfaces:
            self._surfaces[path] = self._surface_of(path)
        count = len(self._surfaces[path][1])
        if not count:
            return "cannot be read as COLLADA"
        return f"has {count} triangles, and at most {_MOST_WRITTEN} are written" if count > _MOST_WRITTEN else ""

    def assets(self) -> tuple[tuple[str, str, str], ...]:
        """Return the name, path and scale of each mesh in a file that MuJoCo reads."""
        return tuple((name, path, scale) for (path, scale), name in self._meshes.items() if path not in self._surfaces)

    def surfaces(self) -> Iterator[tuple[str, str, str, str]]:
        """Yield the name, scale, corners and triangles of each mesh that is written into the model."""
        for (path, scale), name in self._meshes.items():
            if path in self._surfaces:
                corners, faces = self._surfaces[path]
                yield (
                    name,
                    scale,
                    " ".join(f"{value:.7g}" for corner in corners for value in corner),
                    " ".join(str(number) for face in faces for number in face),
                )


def skeleton_of(
    robot: Robot, joints: Sequence[JointFacts], mesh_path: MeshPath, surface_of: SurfaceOf | None = None
) -> Skeleton:
    """Return a robot's bodies in MuJoCo's format, with its meshes and what was left out."""
    fixed = _BodyWriter(robot, joints, mesh_path, surface_of)
    bodies = fixed.bodies(free=False)
    free = _BodyWriter(robot, joints, mesh_path, surface_of).bodies(free=True)
    surfaces = tuple(fixed.surfaces())
    return Skeleton("\n".join(bodies), "\n".join(free), fixed.assets(), tuple(fixed.notes), surfaces)


def _origin(tag: Tag) -> Pose:
    return origin_of(next(tag.named("origin"), None))


def _pose(pose: Pose) -> str:
    place = "" if pose.place == (0.0, 0.0, 0.0) else f' pos="{_numbers(pose.place)}"'
    w, x, y, z = quaternion(pose.turn)
    return place + ("" if abs(w) == 1.0 else f' quat="{w!r} {x!r} {y!r} {z!r}"')


def _numbers(vector: Vector) -> str:
    return " ".join(repr(float(value)) for value in vector)


def quaternion(turn: Rotation) -> tuple[float, float, float, float]:
    """Return a rotation as a quaternion w x y z."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = turn
    parts = (1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz)
    best = max(range(4), key=lambda n: parts[n])
    size = 2 * math.sqrt(parts[best])
    rows = (
        (size / 4, (zy - yz) / size, (xz - zx) / size, (yx - xy) / size),
        ((zy - yz) / size, size / 4, (xy + yx) / size, (xz + zx) / size),
        ((xz - zx) / size, (xy + yx) / size, size / 4, (yz + zy) / size),
        ((yx - xy) / size, (xz + zx) / size, (yz + zy) / size, size / 4),
    )
    return rows[best]


def _inertial(link: Link | None, *, moves: bool) -> tuple[str | None, bool]:
    """The inertia of a link, and whether it is not the given one because no solid has that.

    A moving link without inertia gets a tiny one.
    """
    inertial = link.inertials[0] if link and link.inertials else None
    mass = (inertial.mass.value if inertial and inertial.mass else None) or 0.0
    if inertial is None or link is None or mass <= 0:
        tiny = f'<inertial pos="0 0 0" mass="{_TINY!r}" diaginertia="{_TINY!r} {_TINY!r} {_TINY!r}"/>'
        return (tiny, False) if moves else (None, False)
    element = next(link.tag.named("inertial"), None)
    frame = _origin(element) if element else Pose()
    values = {name: number.value or 0.0 for name, number in (inertial.inertia or {}).items()}
    # MuJoCo takes either a turned frame or a full inertia: the full one is turned here
    given = [values.get(name, 0.0) if math.isfinite(values.get(name, 0.0)) else 0.0 for name in _MOMENTS]
    valid = nearest_valid(given, mass, _ROUNDING) if any(given) else None
    xx, xy, xz, yy, yz, zz = valid or given
    full = product(product(frame.turn, ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))), transposed(frame.turn))
    if max(abs(value) for row in full for value in row) < _TINY:
        full = ((_TINY, 0.0, 0.0), (0.0, _TINY, 0.0), (0.0, 0.0, _TINY))
    shown = (full[0][0], full[1][1], full[2][2], full[0][1], full[0][2], full[1][2])
    inertia = " ".join(repr(value) for value in shown)
    text = f'<inertial pos="{_numbers(frame.place)}" mass="{mass!r}" fullinertia="{inertia}"/>'
    differs = max(abs(a - b) for a, b in zip(valid or given, given, strict=True))
    return text, differs > _NOTICED * max(map(abs, given))


def _mesh_fault(path: str) -> str:
    """Why MuJoCo cannot read a mesh; empty if it can."""
    kind = os.path.splitext(path)[1].lower()
    if kind not in _MESHES:
        return f"has the type '{kind}', which MuJoCo does not read"
    if not admits(path):
        return "is outside the workspace"
    if kind != ".stl":
        return ""
    try:
        data, size = first_bytes(path, 84), size_of(path)
    except OSError as error:
        return f"cannot be read: {error.strerror}"
    triangles = int.from_bytes(data[80:84], "little")
    if len(data) < 84 or size != 84 + 50 * triangles:  # noqa: PLR2004 (STL's header and triangles)
        return "is not a binary STL file"
    return "" if 0 < triangles <= _MOST_TRIANGLES else f"has {triangles} triangles"
