"""The robot as a tree of bodies and hinges, in numbers: what both the checks without an engine and the engines need."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping

from urdfctl.hints import Any
from urdfctl.model.parts import Number, Tag
from urdfctl.model.robot import Joint, Link, Robot
from urdfctl.record import NamedTuple
from urdfctl.smoke.vectors import (
    UPRIGHT,
    ZERO,
    Pose,
    Rotation,
    Vector,
    about,
    of_angles,
    product,
    scaled,
    transposed,
    unit,
)

MOVABLE = ("revolute", "continuous", "prismatic")
_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


class Body(NamedTuple):
    """A link: mass in kg, centre of mass in its frame in m, inertia about that in kg m², by its frame's axes. `radius`
    is that of its first cylinder or sphere to collide with, None where it has none. Gravity may pass it over."""

    name: str
    mass: float = 0.0
    centre: Vector = ZERO
    inertia: Rotation = (ZERO, ZERO, ZERO)
    radius: float | None = None
    falls: bool = True


class Hinge(NamedTuple):
    """A joint: `pose` of the child in the parent at zero, `axis` of length 1 in the child's frame; limits in rad or m,
    N m or N, rad/s or m/s, None where not given; `mimic`: the joint it follows, multiplier, offset."""

    name: str
    type: str
    parent: str
    child: str
    pose: Pose
    axis: Vector
    lower: float | None = None
    upper: float | None = None
    effort: float | None = None
    velocity: float | None = None
    damping: float = 0.0
    mimic: tuple[str, float, float] | None = None

    @property
    def moves(self) -> bool:
        """Whether controllers can move it."""
        return self.type in MOVABLE

    @property
    def span(self) -> tuple[float, float]:
        """Where it may be: a whole turn where nothing bounds it."""
        if self.type == "continuous" or self.lower is None or self.upper is None or not self.lower < self.upper:
            return -math.pi, math.pi
        return self.lower, self.upper

    @property
    def start(self) -> float:
        """Where it is at spawn: at zero, or at the bound that is nearest to it."""
        low, high = self.span
        return min(max(0.0, low), high)

    def moved(self, position: float) -> Pose:
        """The pose of the child at a position."""
        if self.type == "prismatic":
            return self.pose.then(Pose(scaled(self.axis, position), UPRIGHT))
        return self.pose.then(Pose(ZERO, about(self.axis, position)))


class Mechanism(NamedTuple):
    """A robot: bodies by name, hinges from the root outwards."""

    root: str
    bodies: Mapping[str, Body]
    hinges: tuple[Hinge, ...]

    def hinge(self, name: str) -> Hinge | None:
        """The hinge of a name."""
        return next((hinge for hinge in self.hinges if hinge.name == name), None)

    @property
    def movable(self) -> tuple[Hinge, ...]:
        """The hinges that controllers can move: those that follow others are not among them."""
        return tuple(hinge for hinge in self.hinges if hinge.moves and hinge.mimic is None)

    def start(self) -> dict[str, float]:
        """The position of each hinge at spawn."""
        return {hinge.name: hinge.start for hinge in self.hinges if hinge.moves}

    def poses(self, positions: Mapping[str, float]) -> dict[str, Pose]:
        """The pose of each link in the root's frame."""
        found = {self.root: Pose()}
        for hinge in self.hinges:
            position = positions.get(hinge.name, 0.0)
            if hinge.mimic and hinge.mimic[0] in positions:
                position = positions[hinge.mimic[0]] * hinge.mimic[1] + hinge.mimic[2]
            found[hinge.child] = found[hinge.parent].then(hinge.moved(position) if hinge.moves else hinge.pose)
        return found

    def below(self, link: str) -> set[str]:
        """The links that hang on a link, with it."""
        found = {link}
        for hinge in self.hinges:
            if hinge.parent in found:
                found.add(hinge.child)
        return found

    def above(self, link: str) -> list[Hinge]:
        """The hinges between the root and a link, from the link on."""
        by_child = {hinge.child: hinge for hinge in self.hinges}
        found = []
        while link in by_child:
            found.append(by_child[link])
            link = by_child[link].parent
        return found

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Mechanism:
        """From plain data, in which tuples are lists."""
        bodies = [Body(**{**one, **_tuples(one, "centre", "inertia")}) for one in data["bodies"]]
        hinges = [
            Hinge(**{**one, **_tuples(one, "axis", "mimic"), "pose": Pose(*_tuple(one["pose"]))})
            for one in data["hinges"]
        ]
        return cls(data["root"], {body.name: body for body in bodies}, tuple(hinges))

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        bodies, hinges = [body._asdict() for body in self.bodies.values()], [hinge._asdict() for hinge in self.hinges]
        return {"root": self.root, "bodies": bodies, "hinges": hinges}


def _tuple(value: Any) -> Any:
    return tuple(map(_tuple, value)) if isinstance(value, list) else value


def _tuples(data: dict[str, Any], *names: str) -> dict[str, Any]:
    return {name: _tuple(data[name]) for name in names}


# -- from the description --------------------------------------------------------------------------------------------


def mechanism_of(robot: Robot) -> Mechanism | None:
    """The mechanism that a description makes; None where its links are no tree with one root."""
    names = [link.name for link in robot.links if link.name]
    hinges = [hinge for joint in robot.joints if (hinge := _hinge(joint)) is not None]
    children = [hinge.child for hinge in hinges]
    roots = [name for name in names if name not in children]
    unique = len(set(names)) == len(names) and len(set(children)) == len(children)
    if len(roots) != 1 or not unique or len({hinge.name for hinge in hinges}) != len(hinges):
        return None
    ordered = _ordered(roots[0], hinges)
    if len(ordered) != len(names) - 1 or {roots[0], *(hinge.child for hinge in ordered)} != set(names):
        return None
    floating = set(_weightless(robot))
    bodies = {link.name: _body(link, falls=link.name not in floating) for link in robot.links if link.name}
    return Mechanism(roots[0], bodies, tuple(ordered))


def _ordered(root: str, hinges: list[Hinge]) -> list[Hinge]:
    by_parent: dict[str, list[Hinge]] = {}
    for hinge in hinges:
        by_parent.setdefault(hinge.parent, []).append(hinge)
    found: list[Hinge] = []
    pending = [root]
    while pending:
        here = by_parent.pop(pending.pop(0), [])
        found += here
        pending += [hinge.child for hinge in here]
    return found


def _hinge(joint: Joint) -> Hinge | None:
    parent, child = joint.parent, joint.child
    if not (joint.name and joint.type and parent and parent.name and child and child.name):
        return None
    limit, mimic = joint.limit, joint.mimic
    dynamics = next(joint.tag.named("dynamics"), None)
    return Hinge(
        joint.name,
        joint.type,
        parent.name,
        child.name,
        origin_of(joint.tag),
        unit(numbers_of(joint.axis.text if joint.axis else "1 0 0")),
        _number(limit.lower, 0.0) if limit else None,
        _number(limit.upper, 0.0) if limit else None,
        _number(limit.effort) if limit else None,
        _number(limit.velocity) if limit else None,
        _float(dynamics.attributes.get("damping", "0"), 0.0) if dynamics else 0.0,
        (mimic.joint, _number(mimic.multiplier, 1.0) or 0.0, _number(mimic.offset, 0.0) or 0.0)
        if mimic and mimic.joint
        else None,
    )


def _body(link: Link, *, falls: bool) -> Body:
    name = link.name or ""
    radius = next((radius for one in link.geometries if (radius := _radius(one.role, one.shape)) is not None), None)
    if not link.inertials:
        return Body(name, radius=radius, falls=falls)
    inertial = link.inertials[0]
    tag = next(link.tag.named("inertial"), None)
    origin = origin_of(tag) if tag else Pose()
    given = {key: _number(value, 0.0) or 0.0 for key, value in (inertial.inertia or {}).items()}
    xx, xy, xz, yy, yz, zz = (given.get(key, 0.0) for key in _MOMENTS)
    own: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    inertia = product(product(origin.turn, own), transposed(origin.turn))
    return Body(name, _number(inertial.mass, 0.0) or 0.0, origin.place, inertia, radius, falls)


def _radius(role: str, shape: Tag | None) -> float | None:
    if role != "collision" or shape is None or shape.name not in ("cylinder", "sphere"):
        return None
    return _float(shape.attributes.get("radius", ""), math.nan)


def _weightless(robot: Robot) -> Iterator[str]:
    """The links that gravity passes over in Gazebo."""
    for gazebo in robot.gazebos:
        for tag in (*gazebo.tag.named("turnGravityOff"), *gazebo.tag.named("gravity")):
            off = ("true", "1") if tag.name == "turnGravityOff" else ("false", "0")
            if gazebo.reference and tag.text.strip().lower() in off:
                yield gazebo.reference


def origin_of(tag: Tag) -> Pose:
    """The pose that the `<origin>` in an element gives."""
    origin = next(tag.named("origin"), None)
    if origin is None:
        return Pose()
    return Pose(
        numbers_of(origin.attributes.get("xyz", "0 0 0")), of_angles(*numbers_of(origin.attributes.get("rpy", "0 0 0")))
    )


def numbers_of(text: str) -> Vector:
    """The first three numbers of a text, 0 where there are fewer."""
    numbers = [_float(part, 0.0) for part in text.split()[:3]]
    x, y, z = (*numbers, 0.0, 0.0, 0.0)[:3]
    return x, y, z


def _number(number: Number | None, otherwise: float | None = None) -> float | None:
    return otherwise if number is None else _float(number.text, math.nan)


def _float(text: str, otherwise: float) -> float:
    """A number as C++ reads it, `nan` and `inf` too."""
    return (
        float(text)
        if re.fullmatch(r"\s*[+-]?(\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?|nan|inf)\s*", text, re.IGNORECASE)
        else otherwise
    )
