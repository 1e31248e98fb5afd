"""How a robot stands in a simulator: fixed to the world or free, and how high above the ground."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator

from urdfctl.errors import UserError
from urdfctl.generate.options import GeneratorOptions
from urdfctl.generate.robot.anatomy import anatomy_of
from urdfctl.generate.robot.facts import RobotFacts
from urdfctl.generate.robot.frames import frames_of, geometries_of, number_of, origin_of
from urdfctl.model.geometry import Pose
from urdfctl.model.robot import Link, Robot, Tag

WORLD = "world"
BASES = ("fixed", "free")
_LEG = re.compile(r"hip|thigh|calf|knee|ankle|foot|leg(?!o)|coxa|femur|tibia", re.IGNORECASE)
_MOVER = re.compile(r"rotor|prop(eller)?(?![a-z])|thruster|wheel|track", re.IGNORECASE)
_GAP = 0.01
"""How far above the ground a robot is spawned, in m."""
_UNKNOWN = 0.1
"""The height at which a robot without known shapes is spawned, in m."""


def is_fixed(robot: RobotFacts, options: GeneratorOptions) -> bool:
    """Return whether a robot is to be fixed to the world: it has joints, but no wheels, legs or rotors.

    UserError if the user asks for something else than `fixed` or `free`.
    """
    if options.base not in (None, *BASES):
        raise UserError(f"--base must be fixed or free, not '{options.base}'")
    if options.base or not robot.joints:
        return options.base == "fixed"
    anatomy = anatomy_of(robot, robot.joints)
    legs = [chain for chain in anatomy.chains if any(_LEG.search(f"{one.name} {one.link or ''}") for one in chain)]
    moved = any(_MOVER.search(joint.name) for joint in robot.joints)
    return anatomy.base is None and len(legs) <= 1 and not moved


def needs_world(robot: RobotFacts, options: GeneratorOptions) -> bool:
    """Return whether a robot needs a link `world` that Gazebo fixes it to."""
    there = robot.root is None or WORLD in (robot.root, *(joint.link for joint in robot.joints))
    return options.simulator in ("gz", "gazebo-classic") and not there and is_fixed(robot, options)


def spawn_height(robot: RobotFacts, options: GeneratorOptions) -> float:
    """Return the height, in m, at which a simulator gets a robot so that it stands on the ground."""
    if robot.root == WORLD or is_fixed(robot, options):
        return 0.0
    return _UNKNOWN if robot.lowest is None else max(0.0, math.ceil(round((_GAP - robot.lowest) * 100, 3)) / 100)


def lowest_of(robot: Robot) -> float | None:
    """Return the height of a robot's lowest point in the frame of its root, in m; None if it has no shapes.

    All joints are at zero. The size of meshes is unknown: they count with the origin of their link.
    """
    frames = frames_of(robot)
    found = [low for link in robot.links if link.name in frames for low in _lows(link, frames[link.name])]
    return min(found, default=None)


def _lows(link: Link, frame: Pose) -> Iterator[float]:
    shapes = [(geometry.role, geometry.shape, tag) for geometry, tag in geometries_of(link) if geometry.shape]
    solid = [one for one in shapes if one[0] == "collision"] or shapes
    for _, shape, tag in solid:
        pose = frame.then(origin_of(next(tag.named("origin"), None)))
        yield pose.place[2] - _reach(shape, pose) if shape.name != "mesh" else frame.place[2]


def _reach(shape: Tag, pose: Pose) -> float:
    """How far a shape reaches below its centre."""
    x, y, z = (abs(part) for part in pose.turn[2])
    radius, length = (number_of(shape.attributes.get(name)) or 0.0 for name in ("radius", "length"))
    if shape.name == "box":
        sizes = [number_of(word) or 0.0 for word in shape.attributes.get("size", "").split()]
        return sum(part * size / 2 for part, size in zip((x, y, z), sizes, strict=False))
    if shape.name == "sphere":
        return radius
    return radius * math.sqrt(max(0.0, 1 - z * z)) + z * length / 2
