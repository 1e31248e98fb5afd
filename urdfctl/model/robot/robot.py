"""The model of a robot description: links, joints, transmissions, ros2_control components and Gazebo elements."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.model.robot.parts import Number, PartReference, Tag
from urdfctl.model.robot.ros2_control import Ros2Control
from urdfctl.model.robot.transmission import Transmission
from urdfctl.source.span import Place
from urdfctl.startup.per_object import once_for_the_last
from urdfctl.startup.records import NamedTuple

MOVING_TYPES = frozenset({"revolute", "continuous", "prismatic", "floating", "planar"})


class Inertial(NamedTuple):
    """An `<inertial>` element.

    mass: mass in kg; None if missing.
    inertia: the moments `ixx` to `izz` in kg m², by name; None if the element is missing.
    inertia_at: the `<inertia>` element.
    """

    at: Place
    mass: Number | None
    inertia: Mapping[str, Number] | None
    inertia_at: Place | None


class Geometry(NamedTuple):
    """A `<visual>` or `<collision>` element.

    role: `visual` or `collision`.
    shape: the element in `<geometry>`; None if missing.
    """

    role: str
    at: Place
    shape: Tag | None


class Link(NamedTuple):
    """A `<link>` element. ROS reads only the first of its `inertials`."""

    name: str | None
    at: Place
    inertials: tuple[Inertial, ...]
    geometries: tuple[Geometry, ...]
    tag: Tag


class Limit(NamedTuple):
    """A `<limit>` element. Missing attributes are None.

    lower, upper: position in rad or m.
    effort: in N m or N.
    velocity: in rad/s or m/s.
    """

    at: Place
    lower: Number | None
    upper: Number | None
    effort: Number | None
    velocity: Number | None


class Mimic(NamedTuple):
    """A `<mimic>` element; `joint` is the mimicked joint. Missing attributes are None."""

    joint: str | None
    at: Place
    multiplier: Number | None
    offset: Number | None


class Joint(NamedTuple):
    """A `<joint>` element of the robot. Missing attributes and child elements are None."""

    name: str | None
    type: str | None
    at: Place
    parent: PartReference | None
    child: PartReference | None
    axis: Number | None
    limit: Limit | None
    mimic: Mimic | None
    tag: Tag

    @property
    def moves(self) -> bool:
        """Whether joints of this type can move."""
        return self.type in MOVING_TYPES


class Plugin(NamedTuple):
    """A `<plugin>` in a `<gazebo>` element.

    name, filename: the attributes; None if missing.
    tag: the element with its settings.
    """

    name: str | None
    filename: str | None
    at: Place
    tag: Tag

    def setting(self, name: str) -> Tag | None:
        """Return the first child element with a name, if any."""
        return next(self.tag.named(name), None)


class Gazebo(NamedTuple):
    """A `<gazebo>` element.

    reference: name of a link or joint; None if the element is about the whole robot.
    plugins: the `<plugin>` elements in it.
    """

    reference: str | None
    at: Place
    plugins: tuple[Plugin, ...]
    tag: Tag


class MeshFile(NamedTuple):
    """The result of looking up the file of a mesh.

    exists: whether the file exists.
    package: the package in its address; None if the address has none.
    package_found: whether that package was found.
    nearest: the known package or file with the most similar name, if the named one was not found.
    address: the package:// address of the file, of which the mesh gives the path.
    meant: the package:// address that was meant, if the package in the address is a folder of the robot's package.
    package_declared: whether the package was not found, although package.xml declares it.
    """

    exists: bool
    package: str | None = None
    package_found: bool = True
    nearest: str | None = None
    address: str | None = None
    meant: str | None = None
    package_declared: bool = False


class Mesh(NamedTuple):
    """A `<mesh>` element in a visual or collision.

    filename: the address of the file.
    link: name of the link.
    file: the result of looking up the file; None if it was not looked up.
    """

    filename: str
    element: Place
    link: str | None
    file: MeshFile | None

    @property
    def at(self) -> Place:
        """The place of the filename."""
        return self.element["filename"]


class Robot(NamedTuple):
    """A robot description. All parts are in the order of the source.

    name: the robot's name; None if missing.
    at: the root element.
    transmissions: the `<transmission>` elements directly in the root element.
    nested_transmissions: the `<transmission>` elements in other places, except those in `<ros2_control>`.
    ros2_controls: all `<ros2_control>` elements, wherever they are.
    others: the remaining children of the root element.
    element: name of the root element; ROS reads only `robot`.
    version: the version attribute of the root element.
    meshes: the meshes of all links.
    tag: the root element.
    spawned: the plugins for its controllers in the SDF file from which a launch file spawns it.
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
    spawned: tuple[Plugin, ...] = ()

    def joint(self, name: str) -> Joint | None:
        """Return the first joint with a name, if any."""
        return _joints_by_name(self.joints).get(name)

    def link(self, name: str) -> Link | None:
        """Return the first link with a name, if any."""
        return _links_by_name(self.links).get(name)

    @property
    def joint_names(self) -> list[str]:
        """The names of all joints."""
        return [joint.name for joint in self.joints if joint.name]

    @property
    def plugins(self) -> tuple[Plugin, ...]:
        """The plugins of all `<gazebo>` elements, and of the model that is spawned in place of the description."""
        return (*(plugin for gazebo in self.gazebos for plugin in gazebo.plugins), *self.spawned)


@once_for_the_last
def _joints_by_name(joints: tuple[Joint, ...]) -> dict[str, Joint]:
    return {joint.name: joint for joint in reversed(joints) if joint.name is not None}


@once_for_the_last
def _links_by_name(links: tuple[Link, ...]) -> dict[str, Link]:
    return {link.name: link for link in reversed(links) if link.name is not None}
