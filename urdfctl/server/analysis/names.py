"""The names in the files of a robot: where each is defined, and where it is used.

Names of the robot (links, joints, controllers) are taken from the expanded tree, from YAML files, SRDF and launch
files; names of xacro (macros, parameters, properties, arguments) from the files as they are written.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator

from urdfctl.catalog.map_parameters import matching
from urdfctl.load.loader import LoadedTarget
from urdfctl.model.project import Project
from urdfctl.server.analysis.xacro_names import ARGUMENT, xacro_names
from urdfctl.source.disk.files import is_yaml
from urdfctl.source.problem import ReadError
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.source.xml.parsing import parse
from urdfctl.source.yaml.tree import Mapping, Node, Scalar, Sequence, read_yaml
from urdfctl.startup.per_object import once_per_object
from urdfctl.startup.records import NamedTuple
from urdfctl.trace.address import text_in

LINK, JOINT, CONTROLLER = "link", "joint", "controller"


class NamePlace(NamedTuple):
    """One place of a name.

    kind: link, joint, controller, macro, parameter, property or argument.
    text: the name, as it is after expansion.
    span: what is written there: the name, or the expression that it is computed from.
    defines: whether the named thing is defined there.
    scope: for a parameter, the macro; empty for others.
    """

    kind: str
    text: str
    span: SourceSpan
    defines: bool = False
    scope: str = ""

    @property
    def is_computed(self) -> bool:
        """Whether something else than the name is written there."""
        return self.span.text != self.text

    def is_same(self, other: NamePlace) -> bool:
        """Return whether another place is of the same thing."""
        return (self.kind, self.text, self.scope) == (other.kind, other.text, other.scope)


_DEFINED = {("robot", "link", "name"): LINK, ("robot", "joint", "name"): JOINT}
_USED = {
    ("joint", "parent", "link"): LINK,
    ("joint", "child", "link"): LINK,
    ("joint", "mimic", "joint"): JOINT,
    ("transmission", "joint", "name"): JOINT,
    ("ros2_control", "joint", "name"): JOINT,
    ("group", "joint", "name"): JOINT,
    ("group", "link", "name"): LINK,
    ("group", "chain", "base_link"): LINK,
    ("group", "chain", "tip_link"): LINK,
    ("group_state", "joint", "name"): JOINT,
    ("robot", "passive_joint", "name"): JOINT,
    ("robot", "virtual_joint", "child_link"): LINK,
    ("robot", "end_effector", "parent_link"): LINK,
    ("robot", "disable_collisions", "link1"): LINK,
    ("robot", "disable_collisions", "link2"): LINK,
}
"""Attributes that name a link or a joint, by the parent's tag, the tag and the attribute."""
_OF_EITHER = {("robot", "gazebo", "reference")}


def _names_in(loaded: LoadedTarget) -> list[NamePlace]:
    """Return all names in the files of a robot, each place once."""
    found: dict[tuple[str, int, int, str], NamePlace] = {}
    for name in _names(loaded):
        found.setdefault((name.span.file, name.span.start, name.span.end, name.text), name)
    return list(found.values())


names_in = once_per_object(_names_in, most=8)


def name_at(names: Iterable[NamePlace], file: str, offset: int) -> NamePlace | None:
    """Return the name at a byte offset of a file: the shortest of those around it; None if there is none."""
    around = (name for name in names if name.span.file == file and name.span.start <= offset <= name.span.end)
    return min(around, key=lambda name: (name.span.end - name.span.start, not name.defines), default=None)


def _names(loaded: LoadedTarget) -> Iterator[NamePlace]:
    for found in xacro_names(source for source in loaded.sources.values() if source.is_xacro):
        yield NamePlace(*found)
    known: dict[str, set[str]] = {LINK: set(), JOINT: set()}
    if loaded.root is not None:
        for name in _of_robot(loaded.root, known):
            known[name.kind].add(name.text)
            yield name
        yield from _of_plugins(loaded.root, known)
    controllers = loaded.project.controllers
    known[CONTROLLER] = {controller.name for controller in controllers.controllers} if controllers else set()
    for controller in controllers.controllers if controllers else ():
        if controller.declared_at is not None:
            yield NamePlace(CONTROLLER, controller.name, controller.declared_at.span, defines=True)
    launch = loaded.project.launch
    for spawn in launch.spawns if launch else ():
        yield from (NamePlace(CONTROLLER, name, at.part(name).span) for name, at in spawn.names if name)
    if loaded.root is not None:
        path = os.path.realpath(loaded.root.source.path)
        given = (
            one for one in (launch.descriptions if launch else ()) if os.path.realpath(one.file.path or "") == path
        )
        yield from (NamePlace(ARGUMENT, word.text, word.at.part(word.text).span) for one in given for word in one.names)
    parameters = set(_parameters(loaded.project))
    for source in loaded.sources.values():
        if source.path.endswith(".srdf"):
            yield from _of_srdf(source, known)
        elif is_yaml(source.path):
            for document in read_yaml(source).documents:
                yield from (name for name in _of_yaml(document, known, key="") if _place(name.span) not in parameters)


def _parameters(project: Project) -> Iterator[tuple[str, int]]:
    """The places of the keys that are parameters of controllers: `right_wheel: hinge` names no link `right_wheel`."""
    distro = project.distro or next(iter(project.distros[-1:]), None)
    for controller in project.controllers.controllers if project.controllers and distro else ():
        kind = controller.type.value if controller.type else None
        known = project.catalog.controller(kind, distro) if isinstance(kind, str) and distro else None
        for given in controller.own.leaves if known else ():
            matched = matching(given.name, known.parameters) if known else None
            if matched is not None and matched[1] is None:
                yield _place(given.key.span)


def _place(span: SourceSpan) -> tuple[str, int]:
    return span.file, span.start


def _of_robot(root: Element, known: dict[str, set[str]]) -> Iterator[NamePlace]:
    later: list[tuple[Element, str]] = []
    for element in root.walk():
        parent = element.parentNode.tagName if isinstance(element.parentNode, Element) else ""
        for attribute, text in element.attrs.items():
            path = parent, element.tagName, attribute
            if path in _DEFINED:
                yield NamePlace(_DEFINED[path], text, element.at[attribute].span, defines=True)
            elif path in _USED:
                yield NamePlace(_USED[path], text, element.at[attribute].span)
            elif path in _OF_EITHER:
                later.append((element, attribute))
    for element, attribute in later:
        text = element.attrs[attribute]
        kind = JOINT if text in known[JOINT] and text not in known[LINK] else LINK
        yield NamePlace(kind, text, element.at[attribute].span)


def _of_plugins(root: Element, known: dict[str, set[str]]) -> Iterator[NamePlace]:
    """The names in the texts of simulator plugins, sensors and parameters."""
    pending = [element for element in root.elements() if element.tagName in {"gazebo", "ros2_control"}]
    while pending:
        element = pending.pop()
        pending += element.elements()
        words = text_in(element)
        kind = _kind_of(words, element.tagName, known)
        if kind and not element.elements():
            yield NamePlace(kind, words, element.at.content.span)


def _kind_of(text: str, key: str, known: dict[str, set[str]]) -> str | None:
    """The kind of thing that a text names; the key decides if there is a link and a joint of that name."""
    is_frame = "frame" in key.lower() or "link" in key.lower() or "body" in key.lower()
    order = (LINK, JOINT) if is_frame else (JOINT, LINK)
    return next((kind for kind in order if text and text in known[kind]), None)


def _of_srdf(source: SourceText, known: dict[str, set[str]]) -> Iterator[NamePlace]:
    try:
        root = parse(source).documentElement
    except ReadError:
        return
    if root is not None:
        yield from (name._replace(defines=False) for name in _of_robot(root, known))


def _of_yaml(node: Node, known: dict[str, set[str]], key: str) -> Iterator[NamePlace]:
    if isinstance(node, Scalar):
        in_lists = key in {"controller_names", "controllers", "chained_controllers", "fallback_controllers"}
        kind = CONTROLLER if in_lists and node.text in known[CONTROLLER] else _kind_of(node.text, key, known)
        if kind:
            yield NamePlace(kind, node.text, _inside(node))
    elif isinstance(node, Sequence):
        for item in node.items:
            yield from _of_yaml(item, known, key)
    elif isinstance(node, Mapping):
        for entry in node.entries:
            name = entry.key.text.rpartition("/")[2]
            if name in known[CONTROLLER]:
                yield NamePlace(CONTROLLER, name, entry.key.at.part(name).span)
            elif kind := _kind_of(name, key, known):
                yield NamePlace(kind, name, entry.key.at.part(name).span)
            yield from _of_yaml(entry.value, known, name)


def _inside(scalar: Scalar) -> SourceSpan:
    """The span of a scalar without its quotes."""
    quotes = 1 if scalar.style in {"'", '"'} else 0
    return SourceSpan(scalar.source, scalar.start + quotes, scalar.end - quotes)
