"""Which links, joints and interfaces fit a place of a robot, so that writing one causes no new fault.

What a macro contains is written for each of its calls: a name must fit them all, and is offered as the macro writes it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from urdfctl.control.hardware.interfaces import ClaimKind
from urdfctl.control.session import session_of
from urdfctl.load.loader import LoadedTarget
from urdfctl.server.analysis.names import JOINT, LINK, NamePlace, names_in
from urdfctl.server.analysis.question import Question
from urdfctl.source.opaque import UNKNOWN
from urdfctl.source.problem import ReadError
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse
from urdfctl.startup.records import NamedTuple
from urdfctl.trace.address import text_in

_MOVING = frozenset({"revolute", "continuous", "prismatic"})
INTERFACES = {"command_interface": ClaimKind.COMMAND, "state_interface": ClaimKind.STATE}


_KINDS = {
    ("parent", "link"): LINK, ("child", "link"): LINK, ("mimic", "joint"): JOINT, ("gazebo", "reference"): LINK,
    ("chain", "base_link"): LINK, ("chain", "tip_link"): LINK, ("passive_joint", "name"): JOINT,
    ("disable_collisions", "link1"): LINK, ("disable_collisions", "link2"): LINK,
}  # fmt: skip
_NAMES_JOINTS = {"ros2_control", "transmission", "group", "group_state"}


def kind_at(tag: str, attribute: str, parent: Callable[[], str]) -> str | None:
    """Return what an attribute names, a link or a joint; None for others. parent: returns the tag around."""
    if (tag, attribute) == ("joint", "name"):
        return JOINT if parent() in _NAMES_JOINTS else None
    return _KINDS.get((tag, attribute))


def defined_names(question: Question, *kinds: str) -> Iterator[NamePlace]:
    """Yield the known names of some kinds, such as links, where the robots define them."""
    for robot in question.robots:
        for name in names_in(robot):
            if name.kind in kinds and name.defines and name.text and UNKNOWN not in name.text:
                yield name


class Here(NamedTuple):
    """The element at a place, in one robot and one call of its macro."""

    robot: LoadedTarget
    element: Element

    @property
    def parent(self) -> Element | None:
        """The element around it."""
        return self.element.parentNode if isinstance(self.element.parentNode, Element) else None

    def sibling(self, tag: str, attribute: str) -> str:
        """Return an attribute of the first element with a tag beside it; empty if there is none."""
        found = (one for one in (self.parent.elements() if self.parent else ()) if one.tagName == tag)
        return next((one.attrs.get(attribute, "") for one in found if one is not self.element), "")

    def named(self, tag: str) -> list[Element]:
        """Return the links or joints of the robot."""
        return [one for one in self.robot.root.elements() if one.tagName == tag] if self.robot.root is not None else []

    def all(self, outer: str, tag: str) -> Iterator[Element]:
        """Yield the elements with a tag in those of another tag, except the one at the place."""
        for one in self.named(outer):
            yield from (inner for inner in one.elements() if inner.tagName == tag and inner is not self.element)


def elements_at(question: Question) -> list[Here]:
    """Return the elements whose start tag is at the place, in all robots and calls; none if the text is too new."""
    start = question.source.data.rfind(b"<", 0, question.offset)
    found = []
    for robot in question.robots:
        for root in _roots(robot, question.file):
            for element in root.walk():
                is_here = element.start == start and element.source.path == question.file
                if is_here and element.source.data[:start] == question.source.data[:start]:
                    found.append(Here(robot, element))
    return found


def _roots(robot: LoadedTarget, file: str) -> Iterator[Element]:
    if robot.root is not None:
        yield robot.root
    if file.endswith(".srdf") and file in robot.sources:
        try:
            root = parse(robot.sources[file]).documentElement
        except ReadError:
            return
        if root is not None:
            yield root


def fitting_names(question: Question, kind: str) -> Iterator[str]:
    """Yield the names of links or joints that fit the attribute at the place, as they are written there."""
    common: dict[str, None] | None = None
    places = elements_at(question)
    for here in places:
        fits = _test_for(here)
        is_called_again = sum(other.robot is here.robot for other in places) > 1 and _path(here) in _EXCLUSIVE
        texts: dict[str, None] = {}
        beginnings = _beginnings(here)
        for one in here.named(kind):
            name = one.attrs.get("name", "")
            if name and UNKNOWN not in name and fits(name):
                written = one.at["name"].span.text
                if one.call is here.element.call and written != name:
                    texts[written] = None
                computed = [
                    f"{text}{name[len(value) :]}" for value, text in beginnings.items() if name.startswith(value)
                ]
                texts.update(dict.fromkeys(computed))
                if not is_called_again and not computed:
                    texts[name] = None
        common = texts if common is None else {text: None for text in common if text in texts}
    computed = [text for text in common or () if "$" in text]
    yield from computed
    yield from (text for text in common or () if "$" not in text)


def _beginnings(here: Here) -> dict[str, str]:
    """How the macro at the place writes the beginnings of names: `{"left_": "${prefix}"}`; empty outside of macros."""
    found: dict[str, str] = {}
    call = here.element.call
    for element in here.robot.root.walk() if call is not None and here.robot.root is not None else ():
        for attribute, value in element.attrs.items() if element.call is call else ():
            if element is here.element or attribute not in _NAMES:
                continue
            written = re.fullmatch(r"(\$\{[^{}]*\})([^${}]+)", element.at[attribute].span.text)
            if written and value.endswith(written[2]) and len(value) > len(written[2]):
                found[value.removesuffix(written[2])] = written[1]
    return found


_NAMES = frozenset({"name", "link", "joint", "reference"})
Test = Callable[[str], bool]


def _path(here: Here) -> tuple[str, str]:
    return here.parent.tagName if here.parent is not None else "", here.element.tagName


def _test_for(here: Here) -> Test:
    make = _TESTS.get(_path(here))
    return make(here) if make is not None else lambda _: True


# -- the tree of links -------------------------------------------------------------------------------------------------


def _joint_above(here: Here) -> dict[str, str]:
    """The link above each link, without the joint at the place."""
    above = {}
    for joint in here.named(JOINT):
        ends = {one.tagName: one.attrs.get("link", "") for one in joint.elements()}
        if joint is not here.parent and ends.get("child"):
            above[ends["child"]] = ends.get("parent", "")
    return above


def _is_below(link: str, other: str, above: dict[str, str]) -> bool:
    """Whether a link is another one, or hangs on it."""
    seen = set()
    while link not in seen:
        if link == other:
            return True
        seen.add(link)
        link = above.get(link, "")
    return False


def _parent_link(here: Here) -> Test:
    above, child = _joint_above(here), here.sibling("child", "link")
    return lambda name: not child or not _is_below(name, child, above)


def _child_link(here: Here) -> Test:
    above, parent = _joint_above(here), here.sibling("parent", "link")
    return lambda name: name not in above and not (parent and _is_below(parent, name, above))


# -- joints ------------------------------------------------------------------------------------------------------------


def _moving(here: Here) -> dict[str, Element]:
    return {one.attrs.get("name", ""): one for one in here.named(JOINT) if one.attrs.get("type") in _MOVING}


def _mimics(joint: Element) -> bool:
    return any(one.tagName == "mimic" for one in joint.elements())


def _mimicked(here: Here) -> Test:
    joints, own = _moving(here), here.parent.attrs.get("name") if here.parent is not None else None
    return lambda name: name in joints and name != own and not _mimics(joints[name])


def _controlled(here: Here) -> Test:
    """Joints that no hardware has yet; first of all those that controllers claim."""
    is_commanded = any(one.tagName == "command_interface" for one in here.element.elements())
    return _free(here, "ros2_control", may_mimic=not is_commanded)


def _transmitted(here: Here) -> Test:
    return _free(here, "transmission", may_mimic=False)


def _free(here: Here, outer: str, *, may_mimic: bool) -> Test:
    """Moving joints that are in no element of a tag yet; if controllers claim some of them, only these."""
    taken = {one.attrs.get("name") for one in here.all(outer, "joint")}
    joints = ((name, joint) for name, joint in _moving(here).items() if name not in taken)
    free = {name for name, joint in joints if may_mimic or not _mimics(joint)}
    claimed = free & {component for _, component, _ in _unmet(here)}
    return (claimed or free).__contains__


def _grouped(here: Here) -> Test:
    joints, group = {one.attrs.get("name") for one in here.named(JOINT)}, here.parent
    same = group.elements() if group is not None else []
    taken = {one.attrs.get("name") for one in same if one is not here.element and one.tagName == here.element.tagName}
    is_state = group is not None and group.tagName == "group_state"
    allowed = set(_moving(here)) if is_state else joints
    return lambda name: name not in taken and (here.element.tagName != "joint" or name in allowed)


def _chain(here: Here) -> Test:
    """The ends of a chain of a planning group: one hangs on the other."""
    above = _joint_above(here)
    links = {one.attrs.get("name") for one in here.named(LINK)}
    base, tip = (text if text in links else None for text in map(here.element.attrs.get, ("base_link", "tip_link")))
    if base and not tip:
        return lambda name: name != base and _is_below(name, base, above)
    return lambda name: not tip or (name != tip and _is_below(tip, name, above))


def _allowed_collision(here: Here) -> Test:
    given = {here.element.attrs.get("link1"), here.element.attrs.get("link2")}
    same = here.parent.elements() if here.parent is not None else []
    pairs = [
        {one.attrs.get("link1"), one.attrs.get("link2")}
        for one in same
        if one.tagName == "disable_collisions" and one is not here.element
    ]
    return lambda name: name not in given and not any(name in pair and pair & given for pair in pairs)


_TESTS: dict[tuple[str, str], Callable[[Here], Test]] = {
    ("joint", "parent"): _parent_link,
    ("joint", "child"): _child_link,
    ("joint", "mimic"): _mimicked,
    ("ros2_control", "joint"): _controlled,
    ("transmission", "joint"): _transmitted,
    ("group", "joint"): _grouped,
    ("group", "link"): _grouped,
    ("group_state", "joint"): _grouped,
    ("group", "chain"): _chain,
    ("robot", "disable_collisions"): _allowed_collision,
}
_EXCLUSIVE = {("joint", "child"), ("ros2_control", "joint"), ("transmission", "joint")}
"""Where a name can be written only once: a macro that is called twice cannot write it as it is."""


# -- interfaces --------------------------------------------------------------------------------------------------------


def _unmet(here: Here) -> set[tuple[ClaimKind, str, str]]:
    """The interfaces that controllers claim and no hardware offers: kind, component and name."""
    project = here.robot.project
    if project.controllers is None or not project.distros:
        return set()
    session = session_of(project, project.distro or project.distros[-1])
    missing = (one for each in session.candidates for one in each.missing)
    return {(one.kind, one.claim.component, one.claim.interface) for one in missing}


def fitting_interfaces(question: Question) -> Iterator[str]:
    """Yield the interfaces that the joint at the place does not have yet; if controllers claim some, only these."""
    for here in elements_at(question):
        project, joint = here.robot.project, here.parent
        kind = INTERFACES.get(here.element.tagName)
        if joint is None or kind is None or not project.distros:
            continue
        name = joint.attrs.get("name", "")
        claimed = [each for kind_of, component, each in sorted(_unmet(here), key=str) if (kind_of, component) ==
                   (kind, name)]  # fmt: skip
        known = _provided(here, kind, joint)
        taken = {
            one.attrs.get("name")
            for one in joint.elements()
            if one.tagName == here.element.tagName and one is not here.element
        }
        yield from (each for each in claimed or known if each and each not in taken)


def _provided(here: Here, kind: ClaimKind, joint: Element) -> tuple[str, ...]:
    """The interfaces that a joint's hardware provides; the usual ones if the catalogue does not know it."""
    project = here.robot.project
    distro = project.distro or project.distros[-1]
    around = joint.parentNode.elements() if isinstance(joint.parentNode, Element) else []
    plugins = (one for hardware in around if hardware.tagName == "hardware" for one in hardware.elements())
    plugin = next((text_in(one) for one in plugins if one.tagName == "plugin"), "")
    known = project.catalog.hardware(plugin, distro) if plugin else None
    if known is not None and joint.tagName == "joint":
        own = known.command_interfaces if kind is ClaimKind.COMMAND else known.state_interfaces
        if own is not None:
            return own
    return project.catalog.standard_interfaces(distro)
