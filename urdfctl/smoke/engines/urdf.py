"""The robot as a physics engine can load it: a new URDF that holds only masses, joints and collision geometry.

Engines fail on what real files contain: package addresses, meshes that are missing or broken (these crash the process),
foreign tags, links without mass, lines of 8 KB.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Collection, Iterator, Mapping

from urdfctl.model.geometry import Pose, Rotation, Vector, scaled
from urdfctl.model.robot import Robot, Tag
from urdfctl.smoke.matrices import eigenvalues
from urdfctl.smoke.robot import Hinge, LinkBody, Mechanism
from urdfctl.source.disk.files import first_bytes
from urdfctl.source.disk.gate import size_of
from urdfctl.startup.records import NamedTuple

LEAST_MOVING = 1e-3
"""The mass of a moving link that has none, in kg. Its inertia is a thousandth of that, in kg m²."""
MOST_MESH_BYTES = 20 << 20
_WIDTH = 0.04
"""The width of a wheel whose mesh is ignored, in m."""
_ABSENT = " was not found"
_SHAPES = {"box": ("size",), "cylinder": ("radius", "length"), "sphere": ("radius",)}


class EngineUrdf(NamedTuple):
    """A robot for an engine.

    urdf: the text of its URDF.
    left_out: why collision geometry is ignored, by link.
    broken: those of `left_out` that are not just missing.
    """

    urdf: str
    left_out: Mapping[str, str]
    broken: Mapping[str, str]


def engine_urdf(
    robot: Robot,
    mechanism: Mechanism,
    find_mesh: Callable[[str], str | None],
    wheels: Mapping[str, float],
    *,
    standing: bool,
    damped: Collection[str] = (),
    least: float = 0.0,
) -> EngineUrdf:
    """Return a robot for an engine.

    `find_mesh` returns the path of a mesh, or None. `wheels` holds the links of wheels with the radius that their
    controller uses: a wheel whose mesh cannot be used becomes a cylinder. Collision geometry is kept only if the robot
    is `standing` on the ground. Damping and friction are kept only for the `damped` joints, which are driven by effort:
    a motor-driven joint has them in its motor. Shapes without a size get the `least` one, in m, if there is one.
    """
    left_out: dict[str, str] = {}
    shapes: dict[str, list[str]] = {}
    turning = {hinge.child: hinge for hinge in mechanism.hinges}
    for link in robot.links:
        name = link.name or ""
        for collision in link.tag.named("collision"):
            why, text = _shape(collision, find_mesh, least)
            round_ = _rim(mechanism.bodies[name], turning[name].axis, wheels[name]) if name in wheels else ""
            if why:
                left_out[name] = why
                text = round_
            elif "<mesh" in text and mechanism.bodies[name].radius:
                text = round_  # the corners of a mesh shake the robot
            if standing and text:
                shapes.setdefault(name, []).append(text)
    broken = {name: why for name, why in left_out.items() if not why.endswith(_ABSENT)}
    return EngineUrdf(mechanism_urdf(mechanism, shapes, damped), left_out, broken)


def mechanism_urdf(
    mechanism: Mechanism, shapes: Mapping[str, list[str]] | None = None, damped: Collection[str] = ()
) -> str:
    """Return the URDF of a mechanism, with collision geometry by link; the `damped` joints keep their resistance."""
    moving = {hinge.child for hinge in mechanism.hinges if hinge.type != "fixed"}
    lines = ['<?xml version="1.0"?>', '<robot name="robot">']
    for body in mechanism.bodies.values():
        lines += _link(
            body, (shapes or {}).get(body.name, []), moves=body.name in moving or body.name == mechanism.root
        )
    for hinge in mechanism.hinges:
        lines += _joint(hinge, pushed=hinge.name in damped)
    return "\n".join([*lines, "</robot>", ""])


def quoted(text: str) -> str:
    """Return a text as an attribute's value. `xml.sax.saxutils.quoteattr` would import urllib and more."""
    for mark, entity in (("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ('"', "&quot;")):
        text = text.replace(mark, entity)
    return f'"{text}"'


def _shape(collision: Tag, find_mesh: Callable[[str], str | None], least: float) -> tuple[str, str]:
    """Why collision geometry is ignored (empty if it is not), and its text in the new URDF."""
    geometry = next(collision.named("geometry"), None)
    shape = geometry.children[0] if geometry and geometry.children else None
    if shape is None:
        return "", ""
    origin = next(collision.named("origin"), None)
    attributes = origin.attributes if origin else {}
    place = f"<origin xyz={quoted(attributes.get('xyz', '0 0 0'))} rpy={quoted(attributes.get('rpy', '0 0 0'))}/>"
    if shape.name in _SHAPES:
        values = [(name, _measured(shape.attributes.get(name, ""), least)) for name in _SHAPES[shape.name]]
        if not all(value for _, value in values):
            return f"its {shape.name} has no positive size", ""
        inside = f"<{shape.name} {' '.join(f'{name}={quoted(value)}' for name, value in values)}/>"
    elif shape.name == "mesh":
        address = shape.attributes.get("filename", "")
        path = find_mesh(address)
        why = mesh_fault(path) if path else f"'{address}'{_ABSENT}"
        if why or path is None:
            return why, ""
        inside = f"<mesh filename={quoted(path)} scale={quoted(shape.attributes.get('scale', '1 1 1'))}/>"
    else:
        return "", ""
    return "", f"<collision>{place}<geometry>{inside}</geometry></collision>"


def _measured(text: str, least: float) -> str:
    """The size of a shape, with the least one for 0; empty if it is none."""
    try:
        numbers = [float(part) for part in text.split()]
    except ValueError:
        return ""
    if not least:
        return text if all(0 < number < math.inf for number in numbers) else ""
    return " ".join(repr(max(number, least)) for number in numbers) if all(0 <= n < math.inf for n in numbers) else ""


def _rim(body: LinkBody, axis: Vector, given: float) -> str:
    """A wheel as a cylinder: with its own radius, or with the one that its controller uses if its shape is unknown."""
    radius = body.radius or given
    return _wheel(axis, radius, body.aside, body.width or _WIDTH) if radius > 0 else ""


def _wheel(axis: Vector, radius: float, aside: float, width: float) -> str:
    """A cylinder around an axis, some way along it."""
    yaw, pitch = math.atan2(axis[1], axis[0]), math.acos(max(-1.0, min(1.0, axis[2])))
    place = f'<origin xyz="{_triple(scaled(axis, aside))}" rpy="0 {pitch!r} {yaw!r}"/>'
    return f'<collision>{place}<geometry><cylinder radius="{radius!r}" length="{width!r}"/></geometry></collision>'


def _link(body: LinkBody, shapes: list[str], *, moves: bool) -> Iterator[str]:
    mass = body.mass if body.mass > 0 else LEAST_MOVING if moves else 0.0
    inertia = _balanced(body.inertia, mass)
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = inertia
    yield f"<link name={quoted(body.name)}>"
    yield f'<inertial><origin xyz="{_triple(body.centre)}"/><mass value="{mass!r}"/>'
    yield f'<inertia ixx="{xx!r}" ixy="{xy!r}" ixz="{xz!r}" iyy="{yy!r}" iyz="{yz!r}" izz="{zz!r}"/></inertial>'
    yield from shapes
    yield "</link>"


def _balanced(inertia: Rotation, mass: float) -> Rotation:
    """A possible inertia: engines reject one whose largest moment exceeds the sum of the two others."""
    if not any(inertia[n][n] for n in range(3)):
        return _ball(mass * LEAST_MOVING)
    first, second, third = sorted(value.real for value in eigenvalues(inertia))
    if first <= 0 or third > first + second:
        return _ball(sum(inertia[n][n] for n in range(3)) / 3)
    return inertia


def _ball(moment: float) -> Rotation:
    return (moment, 0.0, 0.0), (0.0, moment, 0.0), (0.0, 0.0, moment)


def _joint(hinge: Hinge, *, pushed: bool) -> Iterator[str]:
    damping, friction = (hinge.damping, hinge.friction) if pushed else (0.0, 0.0)
    kind = hinge.type if hinge.moves else "fixed"
    low, high = hinge.span
    yield f"<joint name={quoted(hinge.name)} type={quoted(kind)}>"
    yield f"<parent link={quoted(hinge.parent)}/><child link={quoted(hinge.child)}/>"
    yield f'<origin xyz="{_triple(hinge.pose.place)}" rpy="{_triple(_angles(hinge.pose))}"/>'
    yield f'<axis xyz="{_triple(hinge.axis)}"/>'
    limits = f'lower="{low!r}" upper="{high!r}" effort="1e6" velocity="1e4"'
    yield f'<limit {limits}/><dynamics damping="{damping!r}" friction="{friction!r}"/>'
    yield "</joint>"


def _triple(vector: Vector) -> str:
    return " ".join(repr(part) for part in vector)


def _angles(pose: Pose) -> Vector:
    """The roll, pitch and yaw of a pose."""
    turn = pose.turn
    flat = math.hypot(turn[0][0], turn[1][0])
    if flat < 1e-9:  # noqa: PLR2004 (pointing straight up or down, where yaw and roll are the same)
        return math.atan2(-turn[1][2], turn[1][1]), math.atan2(-turn[2][0], flat), 0.0
    return math.atan2(turn[2][1], turn[2][2]), math.atan2(-turn[2][0], flat), math.atan2(turn[1][0], turn[0][0])


# -- meshes ----------------------------------------------------------------------------------------------------------


def mesh_fault(path: str) -> str:
    """Return why a mesh cannot be given to an engine, or an empty text."""
    name = os.path.basename(path)
    kind = os.path.splitext(path)[1].lower()
    try:
        if size_of(path) > MOST_MESH_BYTES:
            return f"'{name}' is larger than {MOST_MESH_BYTES >> 20} MiB"
        data = first_bytes(path, MOST_MESH_BYTES)
    except OSError as error:
        return f"'{name}' cannot be read: {error.strerror}"
    fault = _MESHES[kind](data) if kind in _MESHES else f"has the file type '{kind}', which engines cannot read"
    return f"'{name}' {fault}" if fault else ""


def _stl(data: bytes) -> str:
    if data[:5].lower() == b"solid" and b"facet" in data[:1000]:
        return "" if b"vertex" in data else "has no triangles"
    triangles = int.from_bytes(data[80:84], "little")
    if len(data) < 84 or triangles == 0 or len(data) < 84 + 50 * triangles:  # noqa: PLR2004 (the sizes of STL's header and triangle)
        return "is not a complete STL file"
    return ""


def _obj(data: bytes) -> str:
    corners = len(re.findall(rb"(?m)^v\s+\S+\s+\S+\s+\S+", data))
    for face in re.findall(rb"(?m)^f\s+(.*)$", data):
        indices = [int(index) for index in re.findall(rb"(?:^|\s)(-?\d+)", face)]
        if any(not -corners <= index <= corners or index == 0 for index in indices):
            return "has a face with a corner that does not exist"
    return "" if corners and re.search(rb"(?m)^f\s", data) else "has no faces"


def _dae(data: bytes) -> str:
    from xml.parsers.expat import ExpatError, ParserCreate

    try:
        ParserCreate().Parse(data, True)  # noqa: FBT003
    except ExpatError:
        return "is not well-formed XML"
    return "" if b"<triangles" in data or b"<poly" in data else "has no triangles"


_MESHES: Mapping[str, Callable[[bytes], str]] = {".stl": _stl, ".obj": _obj, ".dae": _dae}


def wheel_links(mechanism: Mechanism, joints: Collection[str], radius: float) -> dict[str, float]:
    """Return the links that some wheel joints move, each with the radius."""
    return {hinge.child: radius for hinge in mechanism.hinges if hinge.name in joints}
