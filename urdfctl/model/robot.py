"""The robot that a description describes: links, joints, transmissions, ros2_control components, Gazebo's elements."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from urdfctl.model.parts import Number, Reference, Tag
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.model.transmission import Transmission
from urdfctl.source.span import Place

MOVING_TYPES = frozenset({"revolute", "continuous", "prismatic", "floating", "planar"})


@dataclass(frozen=True, slots=True)
class Inertial:
    """An `<inertial>`: mass in kg, the six moments (`ixx` to `izz`) in kg m²; None where not written."""

    at: Place
    mass: Number | None
    inertia: Mapping[str, Number] | None
    inertia_at: Place | None


@dataclass(frozen=True, slots=True)
class Geometry:
    """The shape of a `<visual>` or `<collision>` (`role`): its element, None where it has none."""

    role: str
    at: Place
    shape: Tag | None


@dataclass(frozen=True, slots=True)
class Link:
    """A `<link>`; a second `<inertial>` is never read."""

    name: str | None
    at: Place
    inertials: tuple[Inertial, ...]
    geometries: tuple[Geometry, ...]
    tag: Tag


@dataclass(frozen=True, slots=True)
class Limit:
    """A `<limit>`: rad or m, N m or N, rad/s or m/s; None where not written."""

    at: Place
    lower: Number | None
    upper: Number | None
    effort: Number | None
    velocity: Number | None


@dataclass(frozen=True, slots=True)
class Mimic:
    """A `<mimic>`."""

    joint: str | None
    at: Place
    multiplier: Number | None
    offset: Number | None


@dataclass(frozen=True, slots=True)
class Joint:
    """A `<joint>` of the robot."""

    name: str | None
    type: str | None
    at: Place
    parent: Reference | None
    child: Reference | None
    axis: Number | None
    limit: Limit | None
    mimic: Mimic | None
    tag: Tag

    @property
    def moves(self) -> bool:
        """Whether its type is one that moves."""
        return self.type in MOVING_TYPES


@dataclass(frozen=True, slots=True)
class Plugin:
    """A `<plugin>` of a `<gazebo>` element, with the settings in it."""

    name: str | None
    filename: str | None
    at: Place
    tag: Tag

    def setting(self, name: str) -> Tag | None:
        """The first child of a name."""
        return next(self.tag.named(name), None)


@dataclass(frozen=True, slots=True)
class Gazebo:
    """A `<gazebo>` element; `reference` names a link or joint, None where it speaks of the whole robot."""

    reference: str | None
    at: Place
    plugins: tuple[Plugin, ...]
    tag: Tag


@dataclass(frozen=True, slots=True)
class Robot:
    """A whole description, each part in the order in which it is written.

    `transmissions` are those that stand directly in the root, `nested_transmissions` those elsewhere but in `<ros2_control>`.
    """

    name: str | None
    at: Place
    links: tuple[Link, ...]
    joints: tuple[Joint, ...]
    transmissions: tuple[Transmission, ...]
    nested_transmissions: tuple[Transmission, ...]
    ros2_controls: tuple[Ros2Control, ...]
    gazebos: tuple[Gazebo, ...]
    others: tuple[Tag, ...]

    def joint(self, name: str) -> Joint | None:
        """The first joint of a name."""
        return next((joint for joint in self.joints if joint.name == name), None)

    @property
    def joint_names(self) -> list[str]:
        """The names of all joints."""
        return [joint.name for joint in self.joints if joint.name]

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of all `<gazebo>` elements."""
        return tuple(plugin for gazebo in self.gazebos for plugin in gazebo.plugins)
