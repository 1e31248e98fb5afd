"""Judge each pair of links on which two matrices of disabled collisions differ, by a measure that shares no code.

`signs_of_hands` tells whether the Setup Assistant can have made a matrix for a description: without a library, from
what its compute_default_collisions.cpp always does. `Poses` samples a robot as that file does, in FCL on the surfaces
of its meshes as trimesh reads them: how often two links touch, and how near they come.
"""

from __future__ import annotations

import math
import random
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import fcl
import numpy as np
import trimesh

REASONS = ("Adjacent", "Default", "Always", "Never")
_MOVING = ("revolute", "continuous", "prismatic")
_SAMPLES, _RARE, _MEASURED, _ENOUGH = 3000, 20_000, 60, 150
"""Poses of a pair; those of one that ours tests, hence touched; those with a distance; contacts that tell a share."""
_NEAR = 0.005
"""Two links that come as near as this, in m, touch in another reading of the same mesh."""
_ALWAYS = (0.9, 0.98)
"""About the share at which a pair always touches, 200 poses at a time tell by chance."""
_UNSEEN = 3e-3
"""What collides less often than this is missed by one in a thousand of the runs at the least density, of 2000 poses."""
_FEW = 4
Pair = frozenset[str]


class Described(NamedTuple):
    """A description. solid: links with collision geometry; seen: those with any, which old versions of MoveIt test."""

    links: frozenset[str]
    solid: frozenset[str]
    seen: frozenset[str]
    joined: tuple[tuple[str, str], ...]


def described(root: ET.Element) -> Described:
    """Return what the signs need of a URDF."""
    links = root.findall("link")
    names = frozenset(link.get("name", "") for link in links)
    solid = frozenset(link.get("name", "") for link in links if link.find("collision/geometry") is not None)
    seen = frozenset(link.get("name", "") for link in links if link.find("visual/geometry") is not None)
    joints = [joint for joint in root.findall("joint") if joint.find("parent") is not None]
    joined = tuple((joint.find("parent").get("link", ""), joint.find("child").get("link", "")) for joint in joints)
    return Described(names, solid, solid | seen, joined)


def adjacent(of: Described, solid: frozenset[str]) -> set[Pair]:
    """Return the pairs that computeConnectionGraph() joins: by a joint, or through links without a shape."""
    near: dict[str, set[str]] = {name: set() for name in of.links}
    for one, other in of.joined:
        near.setdefault(one, set()).add(other)
        near.setdefault(other, set()).add(one)
    for name in [name for name in near if name not in solid]:
        around = near.pop(name)
        for other in around:
            near[other] = (near[other] | around) - {other, name}
    return {frozenset((one, other)) for one, others in near.items() for other in others}


def signs_of_hands(semantic: ET.Element, of: Described) -> list[str]:
    """Return why the Setup Assistant cannot have written a matrix for this description; empty if it can have.

    It disables each pair of neighbours that have geometry; it knows four reasons; it writes the lesser name first; it
    names links of the description only. Versions until melodic take visual geometry where a link has no other: what
    holds for one of both readings is no sign.
    """
    rows = semantic.findall("disable_collisions")
    pairs = {frozenset((row.get("link1", ""), row.get("link2", ""))): row.get("reason", "") for row in rows}
    now, before = adjacent(of, of.solid), adjacent(of, of.seen)
    lacking = [pair for pair in now & before if pair not in pairs]
    unknown = {name for pair in pairs for name in pair} - of.links
    wrong = [pair for pair, why in pairs.items() if why == "Adjacent" and pair <= of.links and pair not in now | before]
    given = set(pairs.values()) - {*REASONS}
    turned = [row for row in rows if row.get("link1", "") > row.get("link2", "")]
    apart = math.comb(len(of.solid), 2) - len(now)
    signs = [
        (not rows, "it disables no pair"),
        (lacking, f"{len(lacking)} neighbours are tested"),
        (unknown, f"it names {len(unknown)} unknown links"),
        (wrong, f"{len(wrong)} that are no neighbours are Adjacent"),
        (given, f"it gives other reasons: {', '.join(sorted(given))}"),
        (turned, f"{len(turned)} pairs have the greater name first"),
        (rows and "Never" not in pairs.values() and apart >= _FEW, f"no pair is Never, of {apart} that may be"),
    ]
    return [said for holds, said in signs if holds]


class Measure(NamedTuple):
    """What is known of a pair. share: of the poses in which it touches; nearest: the least distance seen, in m."""

    share: float
    nearest: float
    at_default: bool
    at_ends: bool
    shapes: str
    moved_by: str


class Poses:
    """A robot whose links are placed, and tested two at a time."""

    def __init__(self, root: ET.Element, packages: Mapping[str, Path], folder: Path) -> None:
        self._packages, self._folder = packages, folder
        self._above = {joint.find("child").get("link", ""): joint for joint in root.findall("joint")}
        self._joints = {joint.get("name", ""): joint for joint in self._above.values()}
        self._links = {link.get("name", ""): link for link in root.findall("link")}
        self._shapes: dict[str, tuple[list[tuple[Any, np.ndarray]], str]] = {}
        self._steps: dict[str, tuple[np.ndarray, np.ndarray, np.ndarray]] = {}

    def measured(self, pair: Pair, *, touched_ours: bool) -> Measure:
        """Return how often two links touch, and how near they come."""
        one, other = sorted(pair)
        shapes = [self._shapes_of(name) for name in (one, other)]
        between = sorted(self._moved_above(one) ^ self._moved_above(other))
        chance = random.Random(0)  # noqa: S311 (it samples poses)
        touched, nearest, count = 0, math.inf, 0
        most = _RARE if touched_ours else _SAMPLES
        while count < (most if between else 1) and touched < _ENOUGH:
            count += 1
            places = self._places((one, other), self._drawn(between, chance))
            met = self._met(shapes, places)
            touched += met
            nearest = 0.0 if met else nearest
            if nearest and count <= _MEASURED:
                nearest = min(nearest, self._apart(shapes, places))
        default = self._met(shapes, self._places((one, other), {}))
        ends = any(self._met(shapes, self._places((one, other), ends)) for ends in self._ends(between))
        kinds = " and ".join(kind for _, kind in shapes)
        return Measure(touched / count, nearest, default, ends, kinds, ", ".join(self._kinds(between)) or "nothing")

    def touching(self, pairs: Iterable[Pair], positions: Mapping[str, float]) -> list[Pair]:
        """Return the pairs that touch with some joints at positions, and the others where MoveIt takes them to be."""
        known = {name: value for name, value in positions.items() if name in self._joints}
        return [
            pair
            for pair in pairs
            if self._met([self._shapes_of(name) for name in sorted(pair)], self._places(sorted(pair), known))
        ]

    def _ends(self, names: Sequence[str]) -> Iterator[dict[str, float]]:
        leaders = sorted({self._leader(name)[0] for name in names})
        for end in (0, 1):
            yield {name: self._range(name)[end] for name in leaders}
            yield from ({name: self._range(name)[end]} for name in leaders)

    def _drawn(self, names: Sequence[str], chance: random.Random) -> dict[str, float]:
        leaders = sorted({self._leader(name)[0] for name in names})
        return {name: chance.uniform(*self._range(name)) for name in leaders}

    def _kinds(self, names: Sequence[str]) -> Iterator[str]:
        for kind in (*_MOVING, "floating", "planar"):
            if count := sum(self._joints[name].get("type") == kind for name in names):
                yield f"{count} {kind}"
        if count := sum(self._joints[name].find("mimic") is not None for name in names):
            yield f"{count} of them mimic"

    def _moved_above(self, link: str) -> set[str]:
        found = set()
        while link in self._above:
            joint = self._above[link]
            if joint.get("type") in _MOVING:
                found.add(joint.get("name", ""))
            link = joint.find("parent").get("link", "")
        return found

    def _leader(self, name: str) -> tuple[str, float, float]:
        """The joint that a joint follows at last, with what it multiplies and adds."""
        factor, offset, told = 1.0, 0.0, set()
        while name not in told and (mimic := self._joints[name].find("mimic")) is not None:
            told.add(name)
            offset += factor * float(mimic.get("offset") or 0)
            factor *= float(mimic.get("multiplier") or 1)
            if mimic.get("joint") not in self._joints:
                break
            name = mimic.get("joint", "")
        return name, factor, offset

    def _range(self, name: str) -> tuple[float, float]:
        joint = self._joints[name]
        limit, soft = joint.find("limit"), joint.find("safety_controller")
        if joint.get("type") == "continuous" or limit is None:
            return -math.pi, math.pi
        low, high = float(limit.get("lower") or 0), float(limit.get("upper") or 0)
        if soft is not None and soft.get("soft_lower_limit") is not None:
            low = max(low, float(soft.get("soft_lower_limit")))
        if soft is not None and soft.get("soft_upper_limit") is not None:
            high = min(high, float(soft.get("soft_upper_limit")))
        return low, max(low, high)

    def _position(self, name: str, given: Mapping[str, float]) -> float:
        leader, factor, offset = self._leader(name)
        low, high = self._range(leader)
        usual = 0.0 if low <= 0 <= high else (low + high) / 2
        return given.get(leader, usual) * factor + offset

    def _places(self, links: Sequence[str], given: Mapping[str, float]) -> list[np.ndarray]:
        ways = [self._way(link) for link in links]
        shared = set(ways[0]) & set(ways[1])
        return [self._place([link for link in way if link not in shared], given) for way in ways]

    def _way(self, link: str) -> list[str]:
        """A link and those that carry it, but the root."""
        way = []
        while link in self._above:
            way.append(link)
            link = self._above[link].find("parent").get("link", "")
        return way

    def _place(self, way: Sequence[str], given: Mapping[str, float]) -> np.ndarray:
        place = np.eye(4)
        for link in way:
            joint = self._above[link]
            if link not in self._steps:
                self._steps[link] = _origin(joint), *_turn(joint)
            origin, axis, cross = self._steps[link]
            if joint.get("type") in _MOVING:
                moved = _moved(joint, axis, cross, self._position(joint.get("name", ""), given))
                place = moved @ place
            place = origin @ place
        return place

    def _shapes_of(self, name: str) -> tuple[list[tuple[Any, np.ndarray]], str]:
        if name not in self._shapes:
            found, kinds = [], set()
            for collision in self._links[name].findall("collision"):
                shape = next(iter(collision.find("geometry") if collision.find("geometry") is not None else ()), None)
                made = self._shape(shape) if shape is not None else None
                kinds.add("nothing" if shape is None else shape.tag if made is not None else f"unreadable {shape.tag}")
                if made is not None:
                    found.append((made, _origin(collision)))
            self._shapes[name] = found, "/".join(sorted(kinds)) or "no shape"
        return self._shapes[name]

    def _shape(self, shape: ET.Element) -> Any:
        if shape.tag == "box":
            made = fcl.Box(*_numbers(shape.get("size"), 3))
        elif shape.tag == "sphere":
            made = fcl.Sphere(float(shape.get("radius", "0")))
        elif shape.tag == "cylinder":
            made = fcl.Cylinder(float(shape.get("radius", "0")), float(shape.get("length", "0")))
        elif shape.tag == "mesh":
            made = self._surface(shape.get("filename", ""), _numbers(shape.get("scale", "1 1 1"), 3))
        else:
            return None
        return made and fcl.CollisionObject(made, fcl.Transform())

    def _surface(self, name: str, scale: Sequence[float]) -> Any:
        path = self._path(name)
        try:
            mesh = trimesh.load(path, force="mesh")
            points, faces = np.array(mesh.vertices) * scale, np.array(mesh.faces)
        except Exception:  # noqa: BLE001 (its loaders raise what they like)
            return None
        if not len(faces):
            return None
        made = fcl.BVHModel()
        made.beginModel(len(points), len(faces))
        made.addSubModel(points, faces)
        made.endModel()
        return made

    def _path(self, name: str) -> Path:
        scheme, _, rest = name.partition("://")
        if scheme in ("package", "model"):
            package, _, inside = rest.partition("/")
            return self._packages.get(package, self._folder / package) / inside
        return self._folder / (rest if scheme == "file" else name)

    def _met(self, shapes: Sequence[tuple[list[Any], str]], places: Sequence[np.ndarray]) -> bool:
        return any(
            fcl.collide(one, other, fcl.CollisionRequest(), fcl.CollisionResult())
            for one, other in self._placed(shapes, places)
        )

    def _apart(self, shapes: Sequence[tuple[list[Any], str]], places: Sequence[np.ndarray]) -> float:
        found = [
            fcl.distance(one, other, fcl.DistanceRequest(), fcl.DistanceResult())
            for one, other in self._placed(shapes, places)
        ]
        return max(0.0, min(found, default=math.inf))

    def _placed(
        self, shapes: Sequence[tuple[list[Any], str]], places: Sequence[np.ndarray]
    ) -> Iterator[tuple[Any, Any]]:
        for (found, _), place in zip(shapes, places, strict=True):
            for made, origin in found:
                at = place @ origin
                made.setTransform(fcl.Transform(at[:3, :3], at[:3, 3]))
        return ((one, other) for one, _ in shapes[0][0] for other, _ in shapes[1][0])


def touching_in_poses(semantic: ET.Element, pairs: Mapping[Pair, str], poses: Poses) -> list[str]:
    """Say which pairs that a matrix calls Never touch in a named pose of an SRDF."""
    never = [pair for pair, why in pairs.items() if why == "Never"]
    found = []
    for state in semantic.findall("group_state"):
        given = [(one.get("name", ""), (one.get("value") or "").split()) for one in state.findall("joint")]
        met = poses.touching(never, {name: float(value[0]) for name, value in given if len(value) == 1})
        found += [f"{state.get('name')} of {state.get('group')}: {', '.join(sorted(pair))}" for pair in met]
    return found


def judged(mine: str, theirs: str, found: Measure) -> str:
    """Say why two matrices differ on a pair: each gives a reason, or `tested`."""
    if "unreadable" in found.shapes or "no" in found.shapes.split():
        return "a shape cannot be read here"
    return _we_disable(mine, found) if theirs == "tested" else _they_disable(theirs, found)


def _they_disable(theirs: str, found: Measure) -> str:
    if theirs not in REASONS:
        return "disabled by a person's reason"
    if not found.share and not found.at_default:
        return "touch at ends of ranges only" if found.at_ends else "OURS tests what was not seen to touch"
    told = {
        "Adjacent": "theirs says Adjacent of other than neighbours",
        "Never": "rare: may be missed in sampling" if found.share < _UNSEEN else "theirs says Never of what touches",
        "Always": "theirs says Always of what seldom touches",
        "Default": "theirs says Default of what does not touch at first",
    }
    if theirs == "Always" and found.share >= _ALWAYS[0]:
        return "about the limit of Always"
    return "OURS tests what touches at first" if theirs == "Default" and found.at_default else told[theirs]


def _we_disable(mine: str, found: Measure) -> str:
    if mine == "Adjacent":
        return "theirs tests neighbours"
    if mine == "Default":
        return "theirs tests what touches at first" if found.at_default else "OURS says Default of what does not touch"
    if mine == "Always":
        if found.share < _ALWAYS[0]:
            return "OURS says Always of what seldom touches"
        return "theirs tests what always touches" if found.share > _ALWAYS[1] else "about the limit of Always"
    if found.share:
        return "rare: ours missed it" if found.share < _UNSEEN else "OURS says Never of what touches"
    return "near: theirs may touch" if found.nearest < _NEAR else "theirs tests what never comes near"


def packages_in(folder: Path) -> dict[str, Path]:
    """Return the packages below a folder, by their names."""
    found: dict[str, Path] = {}
    for path in sorted(folder.rglob("package.xml")):
        try:
            name = ET.parse(path).getroot().findtext("name", "").strip()
        except (ET.ParseError, OSError):
            continue
        found.setdefault(name, path.parent)
    return found


def _origin(element: ET.Element) -> np.ndarray:
    origin = element.find("origin")
    place = np.eye(4)
    if origin is not None:
        roll, pitch, yaw = _numbers(origin.get("rpy", "0 0 0"), 3)
        place[:3, :3] = _about((0, 0, 1), yaw) @ _about((0, 1, 0), pitch) @ _about((1, 0, 0), roll)
        place[:3, 3] = _numbers(origin.get("xyz", "0 0 0"), 3)
    return place


def _turn(joint: ET.Element) -> tuple[np.ndarray, np.ndarray]:
    """The axis of a joint, and the matrix of its cross product."""
    given = joint.find("axis")
    axis = np.array(_numbers(given.get("xyz", "1 0 0") if given is not None else "1 0 0", 3))
    x, y, z = axis = axis / (np.linalg.norm(axis) or 1.0)
    return axis, np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _moved(joint: ET.Element, axis: np.ndarray, cross: np.ndarray, position: float) -> np.ndarray:
    place = np.eye(4)
    if joint.get("type") == "prismatic":
        place[:3, 3] = axis * position
    else:
        place[:3, :3] += math.sin(position) * cross + (1 - math.cos(position)) * cross @ cross
    return place


def _about(axis: Sequence[float], angle: float) -> np.ndarray:
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def _numbers(text: str | None, count: int) -> list[float]:
    given = [float(part) for part in (text or "").split()]
    return given if len(given) == count else [0.0] * count
