"""The robot as a tree of bodies and hinges, in numbers, for the checks without a physics engine and for the engines."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping

from urdfctl.model.geometry import (
    UPRIGHT,
    ZERO,
    Pose,
    Rotation,
    Vector,
    about,
    of_angles,
    plus,
    product,
    scaled,
    transposed,
    unit,
)
from urdfctl.model.parts import Number, Tag
from urdfctl.model.robot import Joint, Link, Robot
from urdfctl.model.ros2_control import Part
from urdfctl.smoke.surfaces import grips_of, weightless
from urdfctl.startup.hints import Any
from urdfctl.startup.records import NamedTuple

MOVABLE = ("revolute", "continuous", "prismatic")
_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


class Body(NamedTuple):
    """A link.

    `mass` is in kg. `centre` is the centre of mass in the link's frame, in m. `inertia` is the inertia about it along
    the axes of that frame, in kg m². `radius` is how far its collision geometry reaches from the axis about which the
    link turns, in m, or None; `aside` is the place along that axis where it reaches farthest, and `width` the length of
    that part, in m. `falls` is False if gravity is turned off for the link. `grip` is the friction coefficient that
    `<gazebo>` gives, or None.
    """

    name: str
    mass: float = 0.0
    centre: Vector = ZERO
    inertia: Rotation = (ZERO, ZERO, ZERO)
    radius: float | None = None
    falls: bool = True
    aside: float = 0.0
    width: float = 0.0
    grip: float | None = None


class Hinge(NamedTuple):
    """A joint.

    `pose` is that of the child in the parent's frame at position 0, and `axis` has length 1 in the child's frame.
    `lower` and `upper` are in rad or m, `effort` in N m or N, `velocity` in rad/s or m/s; each is None if the
    description does not give it. `damping` is in N m s/rad or N s/m, and `friction`, which does not depend on the
    speed, in N m or N. `mimic` is the leading joint with multiplier and offset. `ranges` holds the command interfaces
    for which `<ros2_control>` gives a range, each with its minimum and maximum; `initial` is the position that it gives
    to start from, or None.
    """

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
    friction: float = 0.0
    mimic: tuple[str, float, float] | None = None
    ranges: tuple[tuple[str, float, float], ...] = ()
    initial: float | None = None

    @property
    def moves(self) -> bool:
        """Whether controllers can move the joint."""
        return self.type in MOVABLE

    @property
    def unit(self) -> str:
        """The unit of its position."""
        return "m" if self.type == "prismatic" else "rad"

    @property
    def effort_unit(self) -> str:
        """The unit of its effort."""
        return "N" if self.type == "prismatic" else "N m"

    @property
    def span(self) -> tuple[float, float]:
        """Its position limits, or one turn if it has none; twice the same if they leave no range."""
        if self.type == "continuous" or self.lower is None or self.upper is None:
            return -math.pi, math.pi
        if not math.isfinite(self.lower) or not math.isfinite(self.upper):
            return -math.pi, math.pi
        return self.lower, max(self.lower, self.upper)

    @property
    def start(self) -> float:
        """Its position at spawn: the initial one, or 0, or the limit nearest to that."""
        low, high = self.span
        return min(max(self.initial or 0.0, low), high)

    def range_of(self, interface: str) -> tuple[float, float]:
        """Return the least and the greatest command that `<ros2_control>` allows for an interface."""
        return next((entry[1:] for entry in self.ranges if entry[0] == interface), (-math.inf, math.inf))

    def moved(self, position: float) -> Pose:
        """Return the pose of the child in the parent's frame at a position."""
        if self.type == "prismatic":
            return self.pose.then(Pose(scaled(self.axis, position), UPRIGHT))
        return Pose(self.pose.place, product(self.pose.turn, about(self.axis, position)))


class Mechanism(NamedTuple):
    """A robot: bodies by name, and hinges in order from the root outwards."""

    root: str
    bodies: Mapping[str, Body]
    hinges: tuple[Hinge, ...]

    def hinge(self, name: str) -> Hinge | None:
        """Return the hinge with a name, or None."""
        return next((hinge for hinge in self.hinges if hinge.name == name), None)

    @property
    def movable(self) -> tuple[Hinge, ...]:
        """The hinges that controllers can move, without those that mimic others."""
        return tuple(hinge for hinge in self.hinges if hinge.moves and hinge.mimic is None)

    @property
    def is_fixed(self) -> bool:
        """Whether the robot is fixed to the world: its root link is named so."""
        return self.root == "world"

    def start(self) -> dict[str, float]:
        """Return the position of each hinge at spawn."""
        return {hinge.name: hinge.start for hinge in self.hinges if hinge.moves}

    def poses(self, positions: Mapping[str, float]) -> dict[str, Pose]:
        """Return the pose of each link in the root's frame."""
        poses = {self.root: Pose()}
        for hinge in self.hinges:
            position = positions.get(hinge.name, 0.0)
            if hinge.mimic and hinge.mimic[0] in positions:
                position = positions[hinge.mimic[0]] * hinge.mimic[1] + hinge.mimic[2]
            poses[hinge.child] = poses[hinge.parent].then(hinge.moved(position) if hinge.moves else hinge.pose)
        return poses

    def centre_of_mass(self, poses: Mapping[str, Pose]) -> Vector:
        """Return the centre of mass in the root's frame, in m, for some poses of the links. The robot has a mass."""
        mass = sum(body.mass for body in self.bodies.values())
        centre = ZERO
        for name, body in self.bodies.items():
            centre = plus(centre, scaled(poses[name].at(body.centre), body.mass / mass))
        return centre

    def below(self, link: str) -> set[str]:
        """Return a link and all links that hang on it."""
        links = {link}
        for hinge in self.hinges:
            if hinge.parent in links:
                links.add(hinge.child)
        return links

    def body_of(self, link: str) -> set[str]:
        """Return a link and all links below it that are fixed to it."""
        links = {link}
        for hinge in self.hinges:
            if hinge.parent in links and not hinge.moves:
                links.add(hinge.child)
        return links

    def above(self, link: str) -> list[Hinge]:
        """Return the hinges from a link up to the root."""
        by_child = {hinge.child: hinge for hinge in self.hinges}
        hinges = []
        while link in by_child:
            hinges.append(by_child[link])
            link = by_child[link].parent
        return hinges

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Mechanism:
        """Return the mechanism that plain data holds, in which tuples are lists."""
        bodies = [Body(**{**body, **_tuples(body, "centre", "inertia")}) for body in data["bodies"]]
        hinges = [
            Hinge(**{**hinge, **_tuples(hinge, "axis", "mimic", "ranges"), "pose": Pose(*_tuple(hinge["pose"]))})
            for hinge in data["hinges"]
        ]
        return cls(data["root"], {body.name: body for body in bodies}, tuple(hinges))

    def to_json(self) -> dict[str, Any]:
        """Return the mechanism as plain data."""
        bodies, hinges = [body._asdict() for body in self.bodies.values()], [hinge._asdict() for hinge in self.hinges]
        return {"root": self.root, "bodies": bodies, "hinges": hinges}


def _tuple(value: Any) -> Any:
    return tuple(map(_tuple, value)) if isinstance(value, list) else value


def _tuples(data: dict[str, Any], *names: str) -> dict[str, Any]:
    return {name: _tuple(data[name]) for name in names}


# -- from the description --------------------------------------------------------------------------------------------


def mechanism_of(robot: Robot) -> Mechanism | None:
    """Return the mechanism of a robot description, or None if its links do not form a tree with one root."""
    names = [link.name for link in robot.links if link.name]
    hinges = hinges_of(robot)
    children = [hinge.child for hinge in hinges]
    roots = [name for name in names if name not in children]
    unique = len(set(names)) == len(names) and len(set(children)) == len(children)
    if len(roots) != 1 or not unique or len({hinge.name for hinge in hinges}) != len(hinges):
        return None
    ordered = _ordered(roots[0], hinges)
    if len(ordered) != len(names) - 1 or {roots[0], *(hinge.child for hinge in ordered)} != set(names):
        return None
    floating = set(weightless(robot))
    grips = dict(grips_of(robot))
    bodies = {
        link.name: _body(link, falls=link.name not in floating)._replace(grip=grips.get(link.name))
        for link in robot.links
        if link.name
    }
    return Mechanism(roots[0], bodies, tuple(ordered))


def hinges_of(robot: Robot) -> list[Hinge]:
    """Return the hinges of a robot description in its order, also if they form no tree."""
    controls = _controls(robot)
    return [hinge for joint in robot.joints if (hinge := _hinge(joint, controls.get(joint.name or ""))) is not None]


def _ordered(root: str, hinges: list[Hinge]) -> list[Hinge]:
    by_parent: dict[str, list[Hinge]] = {}
    for hinge in hinges:
        by_parent.setdefault(hinge.parent, []).append(hinge)
    ordered: list[Hinge] = []
    pending = [root]
    while pending:
        here = by_parent.pop(pending.pop(0), [])
        ordered += here
        pending += [hinge.child for hinge in here]
    return ordered


def _controls(robot: Robot) -> dict[str, Part]:
    """The joints of `<ros2_control>` by name."""
    return {
        part.name: part for whole in robot.ros2_controls for part in whole.parts if part.kind == "joint" and part.name
    }


def _hinge(joint: Joint, control: Part | None) -> Hinge | None:
    parent, child = joint.parent, joint.child
    if not (joint.name and joint.type and parent and parent.name and child and child.name):
        return None
    limit, mimic = joint.limit, joint.mimic
    dynamics = next(joint.tag.named("dynamics"), None)
    return Hinge(
        name=joint.name,
        type=joint.type,
        parent=parent.name,
        child=child.name,
        pose=origin_of(joint.tag),
        axis=unit(numbers_of(joint.axis.text if joint.axis else "1 0 0")),
        lower=_number(limit.lower, 0.0) if limit else None,
        upper=_number(limit.upper, 0.0) if limit else None,
        effort=_number(limit.effort) if limit else None,
        velocity=_number(limit.velocity) if limit else None,
        damping=_resistance(dynamics, "damping"),
        friction=_resistance(dynamics, "friction"),
        mimic=(mimic.joint, _number(mimic.multiplier, 1.0) or 0.0, _number(mimic.offset, 0.0) or 0.0)
        if mimic and mimic.joint
        else None,
        ranges=tuple(_ranges(control)) if control else (),
        initial=_initial(control) if control else None,
    )


def _resistance(dynamics: Tag | None, name: str) -> float:
    value = _float(dynamics.attributes.get(name, "0"), 0.0) if dynamics else 0.0
    return value if 0 < value < math.inf else 0.0


def _ranges(control: Part) -> Iterator[tuple[str, float, float]]:
    for interface in control.interfaces:
        given = [interface.parameter(name) for name in ("min", "max")]
        least, most = (_float(parameter.value, math.nan) if parameter else math.nan for parameter in given)
        if interface.kind == "command" and interface.name and least <= most:
            yield interface.name, least, most


def _initial(control: Part) -> float | None:
    """The initial position: that of the position interfaces, the state's before the command's."""
    named = [interface for interface in control.interfaces if interface.name == "position"]
    for interface in sorted(named, key=lambda interface: interface.kind != "state"):
        given = interface.parameter("initial_value")
        value = _float(given.value, math.nan) if given else math.nan
        if math.isfinite(value):
            return value
    return None


def _body(link: Link, *, falls: bool) -> Body:
    name = link.name or ""
    radii = (_radius(geometry.role, geometry.shape) for geometry in link.geometries)
    radius = next((radius for radius in radii if radius is not None), None)
    if not link.inertials:
        return Body(name, radius=radius, falls=falls)
    inertial = link.inertials[0]
    tag = next(link.tag.named("inertial"), None)
    origin = origin_of(tag) if tag else Pose()
    given = {key: _number(value, 0.0) or 0.0 for key, value in (inertial.inertia or {}).items()}
    xx, xy, xz, yy, yz, zz = (given.get(key, 0.0) for key in _MOMENTS)
    own: Rotation = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    inertia = product(product(origin.turn, own), transposed(origin.turn))
    return Body(
        name=name,
        mass=_number(inertial.mass, 0.0) or 0.0,
        centre=origin.place,
        inertia=inertia,
        radius=radius,
        falls=falls,
    )


def _radius(role: str, shape: Tag | None) -> float | None:
    if role != "collision" or shape is None or shape.name not in ("cylinder", "sphere"):
        return None
    return _float(shape.attributes.get("radius", ""), math.nan)


def origin_of(tag: Tag) -> Pose:
    """Return the pose that the `<origin>` in an element gives."""
    origin = next(tag.named("origin"), None)
    if origin is None:
        return Pose()
    return Pose(
        numbers_of(origin.attributes.get("xyz", "0 0 0")), of_angles(*numbers_of(origin.attributes.get("rpy", "0 0 0")))
    )


def numbers_of(text: str) -> Vector:
    """Return the first three numbers of a text, filled up with 0."""
    numbers = [_float(part, 0.0) for part in text.split()[:3]]
    x, y, z = (*numbers, 0.0, 0.0, 0.0)[:3]
    return x, y, z


def _number(number: Number | None, default: float | None = None) -> float | None:
    return default if number is None else _float(number.text, math.nan)


def _float(text: str, default: float) -> float:
    """A number as C++ reads it, including `nan` and `inf`."""
    return (
        float(text)
        if re.fullmatch(r"\s*[+-]?(\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?|nan|inf)\s*", text, re.IGNORECASE)
        else default
    )
