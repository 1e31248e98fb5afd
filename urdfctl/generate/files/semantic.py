"""Generate the SRDF: groups, named poses, end effectors, the virtual joint, and the links that need no test."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator, Sequence

from urdfctl.errors import UserError
from urdfctl.generate.request.planning_group import LinkTree, PlanningGroup
from urdfctl.generate.robot.facts import JointFacts, Linkage, RobotFacts
from urdfctl.generate.text.scalars import xml_text
from urdfctl.source.disk.files import named_bytes
from urdfctl.source.disk.gate import exists
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple

_REASONS = frozenset(("Adjacent", "Default", "Always", "Never"))
"""The reasons for a disabled pair that a generator gives; other ones are a person's."""
_ORDER = ("group", "group_state", "end_effector", "virtual_joint", "passive_joint", "disable_collisions")


class SemanticPart(NamedTuple):
    """An element of an SRDF file, with its attributes and what is in it."""

    tag: str
    attributes: tuple[tuple[str, str], ...]
    parts: tuple[SemanticPart, ...] = ()

    def get(self, name: str) -> str:
        """Return an attribute, or an empty text."""
        return dict(self.attributes).get(name, "")

    @property
    def key(self) -> tuple[str, ...]:
        """What tells it from other elements of its kind."""
        if self.tag == "disable_collisions":
            return (self.tag, *sorted((self.get("link1"), self.get("link2"))))
        return (self.tag, self.get("name"), self.get("group") if self.tag == "group_state" else "")

    @property
    def shown(self) -> str:
        """What it is, for a message."""
        if self.tag == "disable_collisions":
            return f"the pair {self.get('link1')}, {self.get('link2')} ({self.get('reason') or 'without a reason'})"
        what = {"group_state": "pose"}.get(self.tag, self.tag.replace("_", " "))
        return f"the {what} '{self.get('name')}'" + (f" of '{self.get('group')}'" if what == "pose" else "")

    def text(self, indent: str = "  ") -> str:
        """Return it as XML."""
        head = f"{indent}<{self.tag}" + "".join(f' {name}="{xml_text(value)}"' for name, value in self.attributes)
        if not self.parts:
            return f"{head}/>\n"
        return f"{head}>\n" + "".join(part.text(f"{indent}  ") for part in self.parts) + f"{indent}</{self.tag}>\n"


def semantic_parts(
    robot: RobotFacts, linkage: Linkage, groups: Sequence[PlanningGroup], *, in_world: bool
) -> list[SemanticPart]:
    """Return the elements of the SRDF. in_world: the description already has a link `world` that carries the robot."""
    joints = {joint.name: joint for joint in robot.joints}
    for name, low, high in linkage.spans:
        if name in joints:
            joints[name] = joints[name]._replace(lower=low, upper=high)
    rest = dict(linkage.rest)
    parts = [_group(group, robot.joints) for group in groups]
    for group in groups:
        parts += _poses(group, joints, rest)
    parts += [
        _part("end_effector", name=group.name, parent_link=group.mount, group=group.name, parent_group=group.carrier)
        for group in groups
        if group.mount and group.carrier
    ]
    root = LinkTree(linkage.links).root
    if root != "world" and not in_world:
        free = any(joint.type == "continuous" and joint.radius for joint in robot.joints)
        kind, frame = ("planar", "odom") if free else ("fixed", "world")
        parts.append(_part("virtual_joint", name="virtual_joint", type=kind, parent_frame=frame, child_link=root))
    moved = {name for group in groups for name in group.joints}
    parts += [_part("passive_joint", name=n) for n, joint in joints.items() if n not in moved and not joint.mimics]
    parts += [_part("disable_collisions", link1=a, link2=b, reason=reason) for a, b, reason in linkage.pairs]
    return parts


def semantic_text(name: str, command: str, parts: Sequence[SemanticPart]) -> str:
    """Return the text of an SRDF file; `command` is the one for a comment."""
    body = "".join(part.text() for kind in _ORDER for part in parts if part.tag == kind)
    body += "".join(part.text() for part in parts if part.tag not in _ORDER)
    head = f'<?xml version="1.0"?>\n<!-- made by {command} -->\n'
    return f'{head}<robot name="{xml_text(name)}">\n{body}</robot>\n'


def _part(tag: str, *parts: SemanticPart, **attributes: str | None) -> SemanticPart:
    return SemanticPart(tag, tuple((name, value or "") for name, value in attributes.items()), parts)


def _group(group: PlanningGroup, joints: Sequence[JointFacts]) -> SemanticPart:
    """A group; a tool has the joints that follow its own, so that all its fingers are tested together."""
    if group.base and group.tip:
        return _part("group", _part("chain", base_link=group.base, tip_link=group.tip), name=group.name)
    if group.links:
        return _part("group", *(_part("link", name=name) for name in group.links), name=group.name)
    names = [*group.joints]
    for name in names:
        names += [one.name for one in joints if one.mimic and one.mimic[0] == name and one.name not in names]
    return _part("group", *(_part("joint", name=name) for name in names), name=group.name)


def _poses(group: PlanningGroup, joints: dict[str, JointFacts], rest: dict[str, float]) -> Iterator[SemanticPart]:
    if group.links:
        return
    if group.mount:
        far, near = ("open", "close") if _is_drawn_closed(group, joints) else ("close", "open")
        values = {far: _far, near: _near}
        yield from (_pose(name, group, joints, values[name]) for name in ("open", "close"))
        return
    yield _pose("home", group, joints, _home)
    if any(_rounded(rest.get(name, 0.0)) != _rounded(_home(joints[name])) for name in group.joints if name in joints):
        yield _pose("rest", group, joints, lambda joint: rest.get(joint.name, 0.0))


def _pose(
    name: str, group: PlanningGroup, joints: dict[str, JointFacts], value: Callable[[JointFacts], float]
) -> SemanticPart:
    moved = [joints[one] for one in group.joints if one in joints and not joints[one].mimics]
    values = [_part("joint", name=joint.name, value=_rounded(value(joint))) for joint in moved]
    return _part("group_state", *values, name=name, group=group.name)


def _rounded(value: float) -> str:
    """A position, rounded towards 0, so that it stays within the limits."""
    return f"{math.trunc(value * 1e5) / 1e5:g}"


def _home(joint: JointFacts) -> float:
    low, high = _span(joint)
    return 0.0 if low <= 0.0 <= high else (low + high) / 2


def _span(joint: JointFacts) -> tuple[float, float]:
    if joint.type == "continuous" or joint.lower is None or joint.upper is None:
        return -math.pi, math.pi
    return joint.lower, joint.upper


def _is_drawn_closed(group: PlanningGroup, joints: dict[str, JointFacts]) -> bool:
    """Whether a tool is open far from 0: fingers that slide are, and one jaw that turns against a fixed one."""
    moved = [joints[name] for name in group.joints if name in joints]
    is_jaw = len(moved) == 1 and not any(one.mimic and one.mimic[0] == moved[0].name for one in joints.values())
    return is_jaw or any(joint.slides for joint in moved)


def _far(joint: JointFacts) -> float:
    return max(_span(joint), key=abs)


def _near(joint: JointFacts) -> float:
    low, high = _span(joint)
    return min(max(0.0, low), high)


# -- what a person changed --------------------------------------------------------------------------------------------


def with_own_parts(parts: Sequence[SemanticPart], path: str, robot: RobotFacts) -> tuple[list[SemanticPart], list[str]]:
    """Return the elements with those of the file that is there which a person wrote, and what was kept, in words.

    A person's are: groups, poses, end effectors, virtual joints and other elements that differ from the generated
    ones, and disabled pairs with a reason of their own. What names a part that the robot does not have is
    left out, and said.
    """
    if not exists(path):
        return [*parts], []
    try:
        root = parse(SourceText(path, named_bytes(path))).documentElement
    except ReadError:
        raise UserError(f"'{path}' is not well-formed, so that what you changed in it cannot be kept") from None
    there = [_read(element) for element in root.elements()] if root is not None else []
    made = {part.key: part for part in parts}
    own = {part.key: part for part in there if _is_own(part, made.get(part.key))}
    known = _Known(robot, {part.get("name") for part in (*parts, *own.values()) if part.tag == "group"})
    kept = {key: part for key, part in own.items() if not known.lacks(part)}
    notes = [f"kept {part.shown} of '{os.path.relpath(path)}'" for part in kept.values()]
    for key, part in own.items():
        if key not in kept:
            notes.append(f"left out {part.shown}: the robot has no {known.lacks(part)}")
    result = [kept.get(part.key, part) for part in parts]
    return [*result, *(part for key, part in kept.items() if key not in made)], notes


def _is_own(part: SemanticPart, made: SemanticPart | None) -> bool:
    if part.tag == "disable_collisions":
        return part.get("reason") not in _REASONS
    if part.tag == "passive_joint":
        return False
    if made and part.tag == "group_state" and _moved(part) != _moved(made):
        return False  # the group has other joints now
    return made is None or (sorted(made.attributes), made.parts) != (sorted(part.attributes), part.parts)


def _moved(pose: SemanticPart) -> set[str]:
    return {one.get("name") for one in pose.parts}


def _read(element: Element) -> SemanticPart:
    attributes = tuple((name, value) for name, value in element.attrs.items())
    return SemanticPart(element.tagName, attributes, tuple(_read(child) for child in element.elements()))


class _Known:
    """The names that an SRDF of a robot can use."""

    def __init__(self, robot: RobotFacts, groups: set[str]) -> None:
        linked = robot.linkage.links if robot.linkage else ()
        self.links, self.groups = {link.name for link in linked}, groups
        self.joints = {link.joint for link in linked} | {"virtual_joint"}

    def lacks(self, part: SemanticPart) -> str:
        """Return what an element names that is not there, in words; empty if all is there."""
        for name in ("link1", "link2", "base_link", "tip_link", "parent_link", "child_link"):
            if part.get(name) and part.get(name) not in self.links:
                return f"link '{part.get(name)}'"
        for name in ("group", "parent_group"):
            if part.get(name) and part.get(name) not in self.groups:
                return f"group '{part.get(name)}'"
        if part.tag == "joint" and part.get("name") not in self.joints:
            return f"joint '{part.get('name')}'"
        if part.tag == "link" and part.get("name") not in self.links:
            return f"link '{part.get('name')}'"
        return next(filter(None, map(self.lacks, part.parts)), "")
