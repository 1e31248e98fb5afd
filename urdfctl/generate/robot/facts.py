"""The facts about a robot that the generators use: its moving joints, measured at zero, and its control tags."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from urdfctl.model.geometry import Vector
from urdfctl.startup.records import NamedTuple


class Load(NamedTuple):
    """What a joint moves in its worst pose.

    `gravity` is the greatest effort that holds the weight, in N m or N. `heaviest` is the greatest inertia while all
    other joints are locked, `lightest` the least one while they are free, in kg m2 or kg. `coupling` is how many times
    faster than this joint alone all joints slow each other down together, if the damping of each is in proportion to
    its lightest load: 1 if they do not affect each other, at most their number; infinite if it is unknown.
    """

    gravity: float
    heaviest: float
    lightest: float
    coupling: float = math.inf


class JointFacts(NamedTuple):
    """A joint that moves. Limits are in rad or m, N m or N, rad/s or m/s, and None if the robot has none.

    `at` and `axis` are in the frame of the root link. `radius` is that of the wheel it turns, in m, and
    `middle` the middle of its tread in the frame of the root link. `inertia` is the
    load that it moves with all joints at zero, in kg m2, or kg for a prismatic joint; `load` is that of the worst
    pose, None if it is unknown. `damping` and `friction` are its own, in N m s/rad and N m, or N s/m and N.

    `link` is the child link, `above` the next joint towards the root that moves, and `mimic` the joint that it follows,
    with multiplier and offset. `macro` is the xacro macro that made it. `interface`, `gains`, `reduction`, `controller`
    and `controller_type` come from a joint list.
    """

    name: str
    type: str = "revolute"
    mimics: bool = False
    lower: float | None = None
    upper: float | None = None
    effort: float | None = None
    velocity: float | None = None
    at: Vector | None = None
    axis: Vector | None = None
    radius: float | None = None
    inertia: float | None = None
    interface: str | None = None
    gains: tuple[tuple[str, float], ...] = ()
    reduction: float = 1.0
    link: str | None = None
    above: str | None = None
    mimic: tuple[str, float, float] | None = None
    controller: str | None = None
    controller_type: str | None = None
    load: Load | None = None
    damping: float = 0.0
    friction: float = 0.0
    middle: Vector | None = None
    macro: str = ""

    @property
    def can_move(self) -> bool:
        """Whether its limits leave it a range and a velocity."""
        return self.velocity != 0 and (self.lower is None or self.lower != self.upper)

    @property
    def slides(self) -> bool:
        """Whether it is prismatic, so that its positions are in metres."""
        return self.type == "prismatic"


class PartFacts(NamedTuple):
    """A joint, sensor or gpio (`kind`) of a `<ros2_control>` tag, with the interfaces that it offers."""

    kind: str
    name: str
    commands: tuple[str, ...] = ()
    states: tuple[str, ...] = ()


class Skeleton(NamedTuple):
    """The bodies of a robot in MuJoCo's format: with its root fixed to the world, and with a free root.

    `meshes` are the name, path and scale of each one. `notes` say what MuJoCo cannot have. `surfaces` are name, scale,
    corners and triangles of meshes whose files it does not read.
    """

    fixed: str
    free: str
    meshes: tuple[tuple[str, str, str], ...]
    notes: tuple[str, ...]
    surfaces: tuple[tuple[str, str, str, str], ...] = ()


class LinkFacts(NamedTuple):
    """A link with its parent link, and the joint between them with its type; the root has none."""

    name: str
    parent: str = ""
    joint: str = ""
    type: str = ""


class Linkage(NamedTuple):
    """The links of a robot from the root outwards, for planning.

    `pairs` are those that need no test for collisions, each with the reason. `hulls` are the links whose meshes were
    tested as convex hulls, for want of FCL. `rest` are the positions at which its joints start, `starting` the other
    pairs that touch there. `spans` are the ranges of the joints whose limits are narrower for planning.
    """

    links: tuple[LinkFacts, ...]
    pairs: tuple[tuple[str, str, str], ...]
    hulls: tuple[str, ...]
    rest: tuple[tuple[str, float], ...]
    starting: tuple[tuple[str, str], ...] = ()
    spans: tuple[tuple[str, float, float], ...] = ()

    @classmethod
    def from_json(cls, plain: Sequence[Any]) -> Linkage:
        """Return it from plain data."""
        links, pairs, hulls, rest, starting, spans = plain
        return cls(
            tuple(LinkFacts(*link) for link in links),
            tuple((one, other, reason) for one, other, reason in pairs),
            tuple(hulls),
            tuple((name, position) for name, position in rest),
            tuple((one, other) for one, other in starting),
            spans=tuple((name, low, high) for name, low, high in spans),
        )


class OwnController(NamedTuple):
    """A controller in a file that a robot's plugin loads, with its joints and commanded interfaces."""

    name: str
    type: str
    joints: tuple[str, ...] = ()
    interfaces: tuple[str, ...] = ()


class RobotFacts(NamedTuple):
    """A robot as the generators use it.

    `file` is its source file, `package` the package that contains it, and `package_path` its path in that package.
    `root` is its root link, `fixed` are the joints that do not move. `interfaces` are the command interfaces that its
    joints already have from transmissions or `<ros2_control>` tags. `parts` are the joints, sensors and gpios of these
    tags. `hosts` are the file names of its simulator plugins, `hosted` the parameter files
    that these load. `sensor_links` are the links of its sensors by name.
    `distro` is that of the robot, None if several `distros` are possible. `arguments` are its xacro arguments with
    their defaults. `skeleton` is there if the simulator is MuJoCo. `generated` are the components that
    gen-ros2-control wrote, with their parts, and the joints of transmissions that gen-transmissions wrote. `lowest` is
    the height of the lowest point in the frame of the root, in m, with all joints at zero. `mesh_packages` contain its
    meshes. `linkage` is there if a motion planner is configured, and `own` are the controllers in the files that its
    plugins load; `own_file` is the package and the path in it of the only one, None if it is in no package. `plugins`
    are the hardware plugins of its `<ros2_control>` tags, and `space` is the namespace in which
    a plugin of a simulator runs the controller manager, empty at the root.
    """

    name: str | None = None
    file: str | None = None
    package: str | None = None
    package_path: str | None = None
    root: str | None = None
    joints: tuple[JointFacts, ...] = ()
    fixed: tuple[str, ...] = ()
    interfaces: Mapping[str, tuple[str, ...]] = {}
    parts: tuple[PartFacts, ...] = ()
    components: tuple[str, ...] = ()
    hosts: tuple[str, ...] = ()
    hosted: tuple[str, ...] = ()
    sensor_links: Mapping[str, str] = {}
    distro: str | None = None
    distros: tuple[str, ...] = ()
    ros: int | None = None
    simulator: str | None = None
    arguments: Mapping[str, str] = {}
    skeleton: Skeleton | None = None
    generated: tuple[str, ...] = ()
    lowest: float | None = None
    mesh_packages: tuple[str, ...] = ()
    linkage: Linkage | None = None
    own: tuple[OwnController, ...] = ()
    own_file: tuple[str, str] | None = None
    plugins: tuple[str, ...] = ()
    space: str = ""

    def of_kind(self, kind: str) -> tuple[PartFacts, ...]:
        """Return the joints, sensors or gpios of its `<ros2_control>` tags."""
        return tuple(part for part in self.parts if part.kind == kind)

    def to_json(self) -> dict[str, Any]:
        """Return it as plain data."""
        return {**self._asdict(), "joints": [joint._asdict() for joint in self.joints], "parts": [*self.parts]}

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> RobotFacts:
        """Return it from plain data."""
        values: dict[str, Any] = {n: tuple(value) if isinstance(value, list) else value for n, value in plain.items()}
        values["joints"] = tuple(_joint(joint) for joint in plain["joints"])
        values["parts"] = tuple(
            PartFacts(kind, name, tuple(commands), tuple(states)) for kind, name, commands, states in plain["parts"]
        )
        values["interfaces"] = {joint: tuple(names) for joint, names in plain["interfaces"].items()}
        skeleton = plain.get("skeleton")
        if skeleton:
            fixed, free, meshes, notes, surfaces = skeleton
            files, inside = (tuple((*mesh,) for mesh in each) for each in (meshes, surfaces))
            values["skeleton"] = Skeleton(fixed, free, files, tuple(notes), inside)
        values["own"] = tuple(
            OwnController(name, kind, tuple(joints), tuple(commanded)) for name, kind, joints, commanded in plain["own"]
        )
        values["linkage"] = Linkage.from_json(plain["linkage"]) if plain.get("linkage") else None
        return cls(**values)


NO_ROBOT = RobotFacts()


def _joint(plain: Mapping[str, Any]) -> JointFacts:
    values: dict[str, Any] = {n: tuple(value) if isinstance(value, list) else value for n, value in plain.items()}
    values["load"] = Load(*plain["load"]) if plain["load"] else None
    return JointFacts(**{**values, "gains": tuple((name, gain) for name, gain in plain["gains"])})
