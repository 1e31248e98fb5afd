"""The robot that a description describes: links, joints, transmissions, ros2_control components, Gazebo's elements."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.model.parts import Number, Reference, Tag
from urdfctl.model.ros2_control import Ros2Control
from urdfctl.model.transmission import Transmission
from urdfctl.record import NamedTuple
from urdfctl.source.span import Place

MOVING_TYPES = frozenset({"revolute", "continuous", "prismatic", "floating", "planar"})


class Inertial(NamedTuple):
    """An `<inertial>`: mass in kg, the six moments (`ixx` to `izz`) in kg m²; None where not written."""

    at: Place
    mass: Number | None
    inertia: Mapping[str, Number] | None
    inertia_at: Place | None


class Geometry(NamedTuple):
    """The shape of a `<visual>` or `<collision>` (`role`): its element, None where it has none."""

    role: str
    at: Place
    shape: Tag | None


class Link(NamedTuple):
    """A `<link>`; a second `<inertial>` is never read."""

    name: str | None
    at: Place
    inertials: tuple[Inertial, ...]
    geometries: tuple[Geometry, ...]
    tag: Tag


class Limit(NamedTuple):
    """A `<limit>`: rad or m, N m or N, rad/s or m/s; None where not written."""

    at: Place
    lower: Number | None
    upper: Number | None
    effort: Number | None
    velocity: Number | None


class Mimic(NamedTuple):
    """A `<mimic>`."""

    joint: str | None
    at: Place
    multiplier: Number | None
    offset: Number | None


class Joint(NamedTuple):
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


class Plugin(NamedTuple):
    """A `<plugin>` of a `<gazebo>` element, with the settings in it."""

    name: str | None
    filename: str | None
    at: Place
    tag: Tag

    def setting(self, name: str) -> Tag | None:
        """The first child of a name."""
        return next(self.tag.named(name), None)


class Gazebo(NamedTuple):
    """A `<gazebo>` element; `reference` names a link or joint, None where it speaks of the whole robot."""

    reference: str | None
    at: Place
    plugins: tuple[Plugin, ...]
    tag: Tag


class MeshFile(NamedTuple):
    """What was learned of the file that a mesh names.

    `package` is the one that its address names, None where it names none; `nearest` the known package or file that is
    most like the one that was not found; `address` the package:// address that means the same file.
    """

    exists: bool
    package: str | None = None
    package_found: bool = True
    nearest: str | None = None
    address: str | None = None


class Mesh(NamedTuple):
    """A `<mesh>` of a visual or collision; `file` is None where nobody looked for it."""

    filename: str
    element: Place
    link: str | None
    file: MeshFile | None

    @property
    def at(self) -> Place:
        """Where the filename stands."""
        return self.element["filename"]


class Robot(NamedTuple):
    """A whole description, each part in the order in which it is written.

    `transmissions` stand directly in the root, `nested_transmissions` elsewhere, but for the ones
    in `<ros2_control>`. `element` is the root element's name: nothing but `robot` makes a robot of it.
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
    element: str = "robot"
    version: str | None = None
    meshes: tuple[Mesh, ...] = ()
    tag: Tag | None = None

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
