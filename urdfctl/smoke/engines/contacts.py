"""Which links of a robot can touch each other: poses within the limits are sampled in MuJoCo, and contacts counted.

MuJoCo is an engine of the smoke test already, has wheels for the usual platforms, and tests all pairs of a pose in C.
It takes the convex hull of a mesh, which contains the mesh: a pair that never touches as hulls never touches. Those
that do are tested again as the surfaces that they are, as MoveIt tests them, if FCL is installed.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import chain
from random import Random
from typing import Any

from urdfctl.errors import UserError
from urdfctl.model.robot import Robot
from urdfctl.smoke.engines import quick_mujoco
from urdfctl.smoke.engines.engine import installed
from urdfctl.smoke.engines.surfaces import TIE, Surfaces, read_surface, tests_surfaces
from urdfctl.smoke.engines.urdf import engine_urdf
from urdfctl.smoke.robot import Hinge, Mechanism, mechanism_of
from urdfctl.startup.records import NamedTuple

ADJACENT, DEFAULT, ALWAYS, NEVER = "Adjacent", "Default", "Always", "Never"
_LISTED = 3
_STEPS = 2000
"""Links that one joint moves against each other, as those of a gripper, are tested in so many steps of its range."""
_POINT = 1e-6
"""The size in m of a shape whose size is 0: MoveIt tests it as a point, and an engine rejects it."""
_ALWAYS = 0.95
"""A pair that touches in more than this part of the poses always touches, as for MoveIt's setup assistant."""

LinkPair = tuple[str, str]


class Untestable(UserError):
    """The links of a robot cannot be tested; the text says why."""


class TouchingLinks(NamedTuple):
    """What is known of the links of a robot.

    pairs: the links that need no test in planning, each with the reason.
    hulls: the links whose meshes are taken as their convex hulls.
    starting: the other pairs, those that touch where the joints start.
    """

    pairs: tuple[tuple[str, str, str], ...]
    hulls: tuple[str, ...]
    starting: tuple[LinkPair, ...] = ()


class Testable(NamedTuple):
    """A robot whose links can be tested: its mechanism, its URDF for an engine, and its links that have geometry."""

    mechanism: Mechanism
    urdf: str
    solid: tuple[str, ...]


def testable(robot: Robot, find_mesh: Callable[[str], str | None]) -> Testable:
    """Return what is tested of a robot, for which no engine is needed. Raise Untestable if planning needs more."""
    if not robot.links:
        raise Untestable("the description has no links: it is no robot")
    mechanism = mechanism_of(robot)
    if mechanism is None:
        raise Untestable(f"the links of the robot form no tree with one root{_loose(robot)}")
    for joint in robot.joints:
        given = [limit for limit in joint.tag.named("limit") if {"lower", "upper"} & {*limit.attributes}]
        if joint.type in ("revolute", "prismatic") and not given:
            raise Untestable(f"joint '{joint.name}' has no position limits, which planning needs")
    made = engine_urdf(robot, mechanism, find_mesh, {}, standing=True, least=_POINT)
    for link, why in made.left_out.items():
        raise Untestable(f"the collision geometry of link '{link}' cannot be tested: {why}")
    solid = tuple(link.name for link in robot.links if link.name and any(link.tag.named("collision")))
    return Testable(mechanism, made.urdf, solid)


def _loose(robot: Robot) -> str:
    """Why the links of a robot form no tree, as the end of a message; empty if that is not simple."""
    names = {link.name for link in robot.links}
    ends = [(joint, end) for joint in robot.joints for end in (joint.parent, joint.child) if end and end.name]
    lost = next(((joint.name, end.name) for joint, end in ends if end.name not in names), None)
    if lost:
        return f": joint '{lost[0]}' connects link '{lost[1]}', which is not defined"
    carried = {joint.child.name for joint in robot.joints if joint.child}
    roots = [f"'{link.name}'" for link in robot.links if link.name and link.name not in carried]
    return f": no joint carries {' or '.join(roots[:_LISTED])}" if len(roots) > 1 else ""


def touching_links(
    robot: Robot, find_mesh: Callable[[str], str | None], samples: int, seed: int
) -> tuple[Mechanism, TouchingLinks]:
    """Return the mechanism of a robot and its pairs of links. Raise Untestable if they cannot be tested."""
    mechanism, urdf, solid = testable(robot, find_mesh)
    if "mujoco" not in installed():
        raise Untestable("MuJoCo is not installed, which tests the links for collisions: pip install 'urdfctl[smoke]'")
    adjacent = adjacent_pairs(mechanism, solid)
    meeting = _Meeting(urdf, mechanism, solid)
    reasons = dict.fromkeys(adjacent, ADJACENT)
    meeting.build(reasons, 0.0)
    reasons.update(dict.fromkeys(meeting.at_rest(), DEFAULT))
    start = sorted(meeting.at_start())
    meeting.build(reasons, TIE)
    never, always = meeting.sampled(samples, seed)
    reasons.update({pair: NEVER for pair in never if pair not in reasons})
    reasons.update({pair: ALWAYS for pair in always if pair not in reasons})
    hulls = () if tests_surfaces() else tuple(link for link in solid if _has_mesh(robot, link))
    pairs = tuple((*pair, reasons[pair]) for pair in _all_pairs(solid) if pair in reasons)
    starting = tuple(pair for pair in start if pair not in reasons)
    return mechanism, TouchingLinks(pairs, hulls, starting)


def adjacent_pairs(mechanism: Mechanism, solid: Sequence[str]) -> list[LinkPair]:
    """Return the links that a joint connects; a link without geometry connects those on both sides of it."""
    near: dict[str, set[str]] = {name: set() for name in mechanism.bodies}
    for hinge in mechanism.hinges:
        near[hinge.parent].add(hinge.child)
        near[hinge.child].add(hinge.parent)
    for name in [name for name in near if name not in set(solid)]:
        around = near.pop(name)
        for other in around:
            near[other] |= around - {other}
            near[other].discard(name)
    return [pair for pair in _all_pairs(solid) if pair[1] in near[pair[0]]]


def _has_mesh(robot: Robot, name: str) -> bool:
    shapes = (
        shape
        for link in robot.links
        if link.name == name
        for collision in link.tag.named("collision")
        for geometry in collision.named("geometry")
        for shape in geometry.children
    )
    return any(shape.name == "mesh" for shape in shapes)


def _all_pairs(names: Sequence[str]) -> Iterator[LinkPair]:
    return ((name, other) for n, name in enumerate(names) for other in names[n + 1 :])


class _Meeting:
    """The links of a robot in MuJoCo, with all pairs tested but those that need no test."""

    def __init__(self, urdf: str, mechanism: Mechanism, solid: Sequence[str]) -> None:
        self._library: Any = quick_mujoco.load()
        self._urdf, self._mechanism, self._solid = urdf, mechanism, solid
        self._moving = [hinge for hinge in mechanism.hinges if hinge.moves]
        self._leaders = _leaders(self._moving)
        self._between = _between(mechanism, solid)
        self._model: Any = None
        self._data: Any = None

    def build(self, untested: Mapping[LinkPair, str], tie: float) -> None:
        """Make the model again, without a test of some pairs. tie: how near, in m, is as good as touching."""
        from urdfctl.smoke.engines.mujoco_engine import COMPILER, GROUND, read_mesh
        from urdfctl.smoke.engines.urdf import quoted

        library = self._library
        library.set_mju_user_warning(lambda _: None)  # by default it writes MUJOCO_LOG.TXT to the working directory
        above = f'<link name="{GROUND}"/><joint name="{GROUND}" type="fixed"><parent link="{GROUND}"/>'
        above += f"<child link={quoted(self._mechanism.root)}/></joint>"
        text = self._urdf.replace('<robot name="robot">', f'<robot name="robot">{COMPILER}{above}', 1)
        try:
            spec = library.MjSpec.from_string(text)
            # it leaves out neighbours by itself, also those that are neighbours of what is fixed to them
            spec.option.disableflags |= library.mjtDisableBit.mjDSBL_FILTERPARENT
            for shape in spec.geoms:
                shape.contype = shape.conaffinity = 1
                shape.margin = tie
            for mesh in spec.meshes:
                if not (tests_surfaces() and read_surface(mesh)):
                    read_mesh(mesh)
            for link, other in untested:
                spec.add_exclude(bodyname1=link, bodyname2=other)
            self._model = spec.compile()
        except (ValueError, AttributeError) as error:
            raise Untestable(f"MuJoCo rejects the robot: {' '.join(str(error).split())}") from None
        self._data = library.MjData(self._model)
        self._found: dict[tuple[int, int, int], bool] = {}
        self._surfaces = Surfaces(library, self._model, tie) if tests_surfaces() else None
        self._at = {hinge.name: int(self._model.joint(hinge.name).qposadr[0]) for hinge in self._moving}
        self._body = {self._model.body(name).id: name for name in self._solid}

    def at_rest(self) -> set[LinkPair]:
        """Return the pairs that touch with each joint at 0, or in the middle of its range if 0 is out of reach."""
        positions = {hinge.name: _usual(hinge) for hinge in self._moving}
        return self._touching(positions, frozenset()) | self._welded()

    def at_start(self) -> set[LinkPair]:
        """Return the pairs that touch with each joint where it starts."""
        usual = {hinge.name: _usual(hinge) for hinge in self._moving}
        return self._touching({**usual, **self._mechanism.start()}, frozenset())

    def sampled(self, samples: int, seed: int) -> tuple[list[LinkPair], list[LinkPair]]:
        """Return the pairs of links that touch in none of the poses, and those that touch in nearly all of them."""
        chance = Random(seed)  # noqa: S311 (it samples poses)
        simple = [*self._simple_poses()]
        total = len(simple) + samples
        most_apart = total - _ALWAYS * total
        counts = dict.fromkeys(_all_pairs(self._solid), 0)
        known: set[LinkPair] = set()
        for n, pose in enumerate(chain(simple, (self._drawn(chance) for _ in range(samples))), 1):
            for pair in self._touching(pose, known):
                counts[pair] += 1
                if n - counts[pair] >= most_apart:
                    known.add(pair)  # it touches at times: whether it does again makes no difference
        never = [pair for pair, count in counts.items() if not count]
        return never, [pair for pair, count in counts.items() if count and total - count < most_apart]

    def _drawn(self, chance: Random) -> dict[str, float]:
        return {hinge.name: chance.uniform(*hinge.planned) for hinge in self._moving}

    def _simple_poses(self) -> Iterator[dict[str, float]]:
        """The poses that people name: where each joint starts, and with one joint or all at a limit."""
        usual = {hinge.name: _usual(hinge) for hinge in self._moving}
        yield {**usual, **self._mechanism.start()}
        for end in (0, 1):
            yield {hinge.name: hinge.planned[end] for hinge in self._moving}
            yield from ({**usual, hinge.name: hinge.planned[end]} for hinge in self._moving)
            yield {**usual, **{hinge.name: hinge.planned[end] for hinge in self._moving if hinge.type == "prismatic"}}

    def _touching(self, positions: Mapping[str, float], known: Collection[LinkPair]) -> set[LinkPair]:
        """The pairs that touch in a pose, without those that are known already."""
        library, model, data = self._library, self._model, self._data
        for hinge in self._moving:
            leader, factor, offset = self._leaders[hinge.name]
            data.qpos[self._at[hinge.name]] = positions[leader] * factor + offset
        library.mj_kinematics(model, data)
        library.mj_comPos(model, data)
        library.mj_collision(model, data)
        found: set[LinkPair] = set()
        if not data.ncon:
            return found
        shapes = data.contact.geom
        links = model.geom_bodyid[shapes].tolist()
        met = {(*shape, *link) for shape, link in zip(shapes.tolist(), links, strict=True)}
        for one, other, link, second in sorted(met):
            pair = self._pair(self._body[link], self._body[second])
            if pair not in found and pair not in known and self._touch_in(positions, pair, one, other):
                found.add(pair)
        return found

    def _touch_in(self, positions: Mapping[str, float], pair: LinkPair, one: int, other: int) -> bool:
        """Whether two shapes of a pair touch, remembered for each step of the joint between them, if it is one."""
        hinge = self._between.get(pair)
        if hinge is None:
            return self._touch(one, other)
        low, high = hinge.planned
        step = int((positions[hinge.name] - low) / (high - low) * _STEPS) if high > low else 0
        if (one, other, step) not in self._found:
            self._found[one, other, step] = self._touch(one, other)
        return self._found[one, other, step]

    def _touch(self, one: int, other: int) -> bool:
        """Whether two shapes touch whose hulls do."""
        return self._surfaces is None or self._surfaces.meet(self._data, one, other)

    def _welded(self) -> set[LinkPair]:
        """The pairs that touch and cannot move against each other, which MuJoCo does not look at."""
        library, model, data = self._library, self._model, self._data
        shapes: dict[int, list[int]] = {}
        for shape in range(model.ngeom):
            shapes.setdefault(int(model.body_weldid[model.geom_bodyid[shape]]), []).append(shape)
        found = set()
        for group in shapes.values():
            for pair in ((one, other) for n, one in enumerate(group) for other in group[n + 1 :]):
                bodies = [int(model.geom_bodyid[shape]) for shape in pair]
                apart = bodies[0] == bodies[1] or library.mj_geomDistance(model, data, *pair, 1.0, None) > 0
                if not apart and self._touch(*pair):
                    found.add(self._pair(*(self._body[body] for body in bodies)))
        return found

    def _pair(self, one: str, other: str) -> LinkPair:
        order = self._solid.index
        return (one, other) if order(one) < order(other) else (other, one)


def _between(mechanism: Mechanism, solid: Sequence[str]) -> dict[LinkPair, Hinge]:
    """The pairs of links that a single joint moves against each other, alone or with those that follow it, and it."""
    hinges = {hinge.name: hinge for hinge in mechanism.hinges if hinge.moves}
    above = {link: {hinge.name for hinge in mechanism.above(link) if hinge.moves} for link in solid}
    leaders = _leaders([*hinges.values()])
    moved = {pair: {leaders[name][0] for name in above[pair[0]] ^ above[pair[1]]} for pair in _all_pairs(solid)}
    return {pair: hinges[next(iter(names))] for pair, names in moved.items() if len(names) == 1}


def _leaders(moving: Sequence[Hinge]) -> dict[str, tuple[str, float, float]]:
    """The hinge that each one follows at last, itself if none, with what it multiplies and adds."""
    known = {hinge.name: hinge.mimic for hinge in moving}
    found = {}
    for name in known:
        leader, factor, offset, told = name, 1.0, 0.0, set()
        while (mimic := known[leader]) and mimic[0] in known and leader not in told:
            told.add(leader)
            leader, factor, offset = mimic[0], factor * mimic[1], offset + factor * mimic[2]
        found[name] = leader, factor, offset
    return found


def _usual(hinge: Hinge) -> float:
    low, high = hinge.planned
    return 0.0 if low <= 0.0 <= high else (low + high) / 2
