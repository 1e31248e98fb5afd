"""The robot as a tree of bodies and hinges, in numbers, for the checks without a physics engine and for the engines."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from urdfctl.model.geometry import (
    UPRIGHT,
    ZERO,
    Pose,
    Rotation,
    Vector,
    about,
    plus,
    product,
    scaled,
)
from urdfctl.startup.records import NamedTuple

MOVABLE = ("revolute", "continuous", "prismatic")


class LinkBody(NamedTuple):
    """A link as a rigid body.

    mass: in kg.
    centre: the centre of mass in the link's frame, in m.
    inertia: about the centre of mass, along the axes of the link's frame, in kg m².
    radius: how far its collision geometry reaches from the axis about which the link turns, in m, or None.
    falls: False if gravity is turned off for the link.
    aside: the place along the axis where the geometry reaches farthest, in m.
    width: the length of that part, in m.
    off: how far the middle of that geometry is from the axis, in m.
    grip: the friction coefficient that `<gazebo>` gives, or None.
    """

    name: str
    mass: float = 0.0
    centre: Vector = ZERO
    inertia: Rotation = (ZERO, ZERO, ZERO)
    radius: float | None = None
    falls: bool = True
    aside: float = 0.0
    width: float = 0.0
    off: float = 0.0
    grip: float | None = None


class Hinge(NamedTuple):
    """A joint.

    pose: that of the child in the parent's frame at position 0.
    axis: of length 1, in the child's frame.
    lower, upper: its position limits, in rad or m; None if the description does not give them, as the next two.
    effort: its effort limit, in N m or N.
    velocity: its velocity limit, in rad/s or m/s.
    damping: in N m s/rad or N s/m.
    friction: that does not depend on the speed, in N m or N.
    mimic: the leading joint with multiplier and offset.
    ranges: the command interfaces for which `<ros2_control>` gives a range, each with its minimum and maximum.
    initial: the position that `<ros2_control>` gives to start from, or None.
    soft: the soft limits of `<safety_controller>`, or None.
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
    soft: tuple[float, float] | None = None

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
    def planned(self) -> tuple[float, float]:
        """The range in which MoveIt plans: its position limits, where soft limits narrow them."""
        low, high = self.span
        if self.soft is None or self.type == "continuous":
            return low, high
        low = max(low, self.soft[0])
        return low, max(low, min(high, self.soft[1]))

    @property
    def start(self) -> float:
        """Its position at spawn: the initial one, or 0, or the limit nearest to that."""
        low, high = self.span
        return min(max(self.initial or 0.0, low), high)

    def range_of(self, interface: str) -> tuple[float, float]:
        """Return the least and the greatest command that `<ros2_control>` allows for an interface."""
        return next((entry[1:] for entry in self.ranges if entry[0] == interface), (-math.inf, math.inf))

    def within_command_ranges(self) -> Hinge:
        """Return the hinge with the limits of velocity and effort that `<ros2_control>` allows to command."""
        velocity, effort = (
            _least(own, max(map(abs, self.range_of(name))))
            for own, name in ((self.velocity, "velocity"), (self.effort, "effort"))
        )
        return self._replace(velocity=velocity, effort=effort)

    def moved(self, position: float) -> Pose:
        """Return the pose of the child in the parent's frame at a position."""
        if self.type == "prismatic":
            return self.pose.then(Pose(scaled(self.axis, position), UPRIGHT))
        return Pose(self.pose.place, product(self.pose.turn, about(self.axis, position)))


def _least(limit: float | None, most: float) -> float | None:
    """A limit that is not greater than the greatest command; a limit of 0 means something else and is kept."""
    if not math.isfinite(most) or most <= 0 or limit == 0:
        return limit
    return most if limit is None else min(limit, most)


class Mechanism(NamedTuple):
    """A robot: bodies by name, and hinges in order from the root outwards."""

    root: str
    bodies: Mapping[str, LinkBody]
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

    def within_command_ranges(self) -> Mechanism:
        """Return the mechanism with the limits of velocity and effort that `<ros2_control>` allows to command."""
        return self._replace(hinges=tuple(hinge.within_command_ranges() for hinge in self.hinges))

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
        bodies = [LinkBody(**{**body, **_tuples(body, "centre", "inertia")}) for body in data["bodies"]]
        several = ("axis", "mimic", "ranges", "soft")
        hinges = [
            Hinge(**{**hinge, **_tuples(hinge, *several), "pose": Pose(*_tuple(hinge["pose"]))})
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
