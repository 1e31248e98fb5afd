"""Gather parts that are spread over macros and files in one `<ros2_control>` element, a child of `<robot>`.

A part is written where its transmission was. A macro that a robot calls several times cannot open the element itself:
its calls are the parts of the place that contains them. If it also makes links and joints, its parts move to a macro
beside it, which is called in addition.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise

from urdfctl.diagnostic import Edit
from urdfctl.migrate.edits.markup import (
    CONDITIONS,
    MACRO,
    ancestors,
    attribute,
    dedented,
    element_at,
    end_of,
    indent_of,
    indented,
    is_alone,
    lines_of,
    parent_of,
    removal,
    span_of,
    step_of,
)
from urdfctl.migrate.edits.places import ElementKey, key_of_element
from urdfctl.migrate.ros1.parts import Converted, UnreadableTransmission
from urdfctl.migrate.ros1.uses import unit_of
from urdfctl.migrate.todo import todo_line
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.source.xml.dom import Element
from urdfctl.startup.records import NamedTuple

Path = tuple[int, tuple[ElementKey, ...]]
"""A robot's number, and the macro calls that are still around a part, innermost first."""
_BESIDE = "_ros2_control"
_BLOCK_PARAMETER = r"(?:\*\*?\w+)(?:\s*:=\s*\S+)?"
_CALLED = r"\A(<xacro:)((?:[\w-]+\.)*%s)(?=[\s/>]|\Z)"
_TRAILING = r"_?(?:transmissions?|trans|ros_control|control)$"


class PartItem(NamedTuple):
    """A part of a component.

    element: the transmission, or the call of a macro that makes parts.
    text: what is written in the component.
    paths: the robots that have it.
    stays: whether the element also stays where it is.
    names: the joints' names as they are written; none for a call.
    arguments: the xacro arguments that the text reads as properties.
    idle: the robots in which its joint only mimics another one, each with the text for that.
    """

    element: Element
    text: str
    paths: frozenset[Path]
    stays: bool
    names: tuple[str, ...]
    arguments: tuple[tuple[str, str], ...] = ()
    idle: Mapping[Path, str] = {}


class Component(NamedTuple):
    """A component to write: its parts, and the macro or file that it is written in."""

    unit: Element
    items: tuple[PartItem, ...]


class Gathering:
    """The components for some transmissions, and the edits of macros that they need."""

    def __init__(self, read: Mapping[str, SourceText]) -> None:
        self._read = read
        self.edits: dict[ElementKey, list[Edit]] = {}
        """The edits of each macro that was lifted."""
        self._items: dict[ElementKey, dict[ElementKey, PartItem]] = {}
        self._units: dict[ElementKey, Element] = {}

    def add(self, element: Element, part: Converted, paths: Iterable[Path], idle: Mapping[Path, str]) -> None:
        """Add the parts of a transmission. For `idle`, see PartItem."""
        item = PartItem(
            element=element,
            text=part.text,
            paths=frozenset(paths),
            stays=False,
            names=part.joints,
            arguments=part.arguments,
            idle=idle,
        )
        self._put(item)

    def components(self) -> Iterator[Component]:
        """Yield the components to write. Raises Unreadable if parts cannot be moved to where a component can be."""
        while lifted := self._to_lift():
            self._lift(lifted)
        for unit, items in self._items.items():
            yield Component(self._units[unit], tuple(sorted(items.values(), key=lambda item: item.element.start)))

    def _put(self, item: PartItem) -> None:
        unit = unit_of(item.element)
        key = key_of_element(unit)
        self._units[key] = unit
        items = self._items.setdefault(key, {})
        own = key_of_element(item.element)
        known = items.get(own)
        items[own] = item._replace(paths=item.paths | known.paths) if known else item

    def _to_lift(self) -> ElementKey | None:
        """The innermost macro that a robot calls several times."""
        several = [key for key, items in self._items.items() if _is_called_twice(items.values())]
        return max(
            several,
            key=lambda key: max(len(path[1]) for i in self._items[key].values() for path in i.paths),
            default=None,
        )

    def _lift(self, key: ElementKey) -> None:
        macro, items = self._units[key], self._items.pop(key)
        parts = list(items.values())
        calls: dict[ElementKey, set[Path]] = {}
        for item in parts:
            for robot, chain in sorted(item.paths):
                calls.setdefault(chain[0], set()).add((robot, chain[1:]))
        is_pure = _is_pure(macro, parts)
        self.edits.setdefault(key, []).extend(_pure_edits(parts) if is_pure else _split_edits(macro, parts))
        own = attribute(macro, "name")
        arguments = tuple(argument for item in parts for argument in item.arguments)
        for (path, start), paths in calls.items():
            call = element_at(self._read[path], start)
            if call is None:
                raise UnreadableTransmission("the calls of its macro cannot be found")
            if call.tagName == MACRO:  # no file calls it: it was expanded for itself, without a robot
                continue
            text = _idle_text(parts, (path, start)) or f"{_written(call) if is_pure else _call_text(call, own)}\n"
            item = PartItem(
                element=call, text=text, paths=frozenset(paths), stays=not is_pure, names=(), arguments=arguments
            )
            self._put(item)


def _idle_text(parts: Iterable[PartItem], call: ElementKey) -> str:
    """What replaces a call of a macro whose joints only mimic others there; empty if they do not."""
    texts = []
    for item in parts:
        own = [path for path in item.paths if path[1][0] == call]
        if not own or len(own) != len(item.idle.keys() & set(own)) or len({item.idle[path] for path in own}) > 1:
            return ""
        if len(own) < len(item.paths) and item.idle.keys() >= item.paths:
            return ""
        texts.append(item.idle[own[0]])
    return "".join(texts)


def _is_called_twice(items: Iterable[PartItem]) -> bool:
    paths = {path for item in items for path in item.paths if path[1]}
    robots = [robot for robot, _ in paths]
    return len(robots) > len(set(robots))


def _is_pure(macro: Element, items: Iterable[PartItem]) -> bool:
    """Whether a macro makes nothing but the parts."""
    own = {item.element.start for item in items if not item.stays}
    pending = list(macro.elements())
    while pending:
        element = pending.pop()
        if element.tagName in CONDITIONS:
            pending += element.elements()
        elif element.start not in own and element.tagName != "xacro:property":
            return False
    return True


def _written(element: Element) -> str:
    return span_of(element).text


def _pure_edits(items: Iterable[PartItem]) -> Iterator[Edit]:
    """The edits that write parts where their transmissions are."""
    for item in items:
        text = indented(item.text, indent_of(item.element)).strip()
        yield Edit(span_of(item.element), text)


def _split_edits(macro: Element, items: Iterable[PartItem]) -> Iterator[Edit]:
    """The edits that move the parts of a macro to a macro beside it."""
    items = sorted(items, key=lambda item: item.element.start)
    indent, step = indent_of(macro), step_of(macro.source)
    properties = [one for one in macro.elements() if one.tagName == "xacro:property"]
    lines = [f"{_written(one)}\n" for one in properties]
    lines += [_with_conditions(item, macro, step) for item in items]
    parameters = re.sub(_BLOCK_PARAMETER, "", attribute(macro, "params")).split()
    head = f'<{MACRO} name="{attribute(macro, "name")}{_BESIDE}" params="{" ".join(parameters)}">\n'
    text = f"{head}{indented(''.join(lines), step)}</{MACRO}>\n"
    yield from (removal(item.element) for item in items if not item.stays)
    end = end_of(macro)
    yield Edit(SourceSpan(macro.source, end, end), f"\n\n{indented(text, indent)}".rstrip("\n"))


def _with_conditions(item: PartItem, above: Element, step: str) -> str:
    """The text of a part in copies of the conditions between it and the element around it."""
    text = item.text
    for around in ancestors(item.element):
        if around is above:
            return text
        if around.tagName not in CONDITIONS:
            raise UnreadableTransmission(f"it is in <{around.tagName}>")
        tag = around.source.start_tag(around.start)
        opened = around.source.data[around.start : tag.end].decode() if tag else ""
        text = f"{opened}\n{indented(text, step)}</{around.tagName}>\n"
    raise UnreadableTransmission("its macro cannot be found")


def _call_text(call: Element, name: str) -> str:
    """The call of the macro beside a macro, with the same arguments and without blocks. The macro's name may be below
    the namespace that its file is included in, or an attribute of <xacro:call>."""
    tag = call.source.start_tag(call.start)
    start = call.source.data[call.start : tag.end].decode() if tag else ""
    opened = start.rstrip(">").rstrip("/").rstrip()
    pattern = (
        r"(<xacro:call\b[^>]*?\bmacro=[\"'])((?:[\w-]+\.)*%s)(?=[\"'])" if call.tagName == "xacro:call" else _CALLED
    )
    text, count = re.subn(pattern % re.escape(name), rf"\1\2{_BESIDE}", opened, count=1)
    if not count:
        raise UnreadableTransmission(f"the name of its macro is not written in <{call.tagName}>")
    return f"{text}/>"


# -- writing ---------------------------------------------------------------------------------------------------------


def written_component(component: Component, name: str, plugin: str, more: str = "", todo: str = "") -> Iterator[Edit]:
    """Yield the edits that write a component in place of its parts. Raises Unreadable if it cannot be written there.

    more: further parts.
    todo: what a person must decide about the plugin; empty if nothing.
    """
    items = component.items
    place = _common(component)
    step = step_of(place.source)
    if any(around.tagName not in {*CONDITIONS, MACRO, "robot"} for around in (place, *ancestors(place))):
        raise UnreadableTransmission(f"it is in <{place.tagName}>")
    note = f"{step}{todo_line(place.source.path, todo)}\n" if todo else ""
    hardware = f"<hardware>\n{note}{step}<plugin>{plugin}</plugin>\n</hardware>\n"
    properties = "".join(
        f'<xacro:property name="{name}" value="$(arg {argument})"/>\n'
        for name, argument in dict.fromkeys(argument for item in items for argument in item.arguments)
    )

    def whole(body: str, indent: str) -> str:
        inner = indented(f"{properties}{hardware}{body}{more}", step)
        return indented(f'<ros2_control name="{name}" type="system">\n{inner}</ros2_control>\n', indent)

    if _is_run(items, place):
        yield _in_run(items, whole)
        return
    indent = indent_of(
        next(child for child in place.elements() if child.start <= items[-1].element.start < end_of(child))
    )
    body = "".join(_with_conditions(item, place, step) for item in items)
    last = next(child for child in place.elements() if child.start <= items[-1].element.start < end_of(child))
    text = whole(body, indent)
    for item in items[:-1]:
        if not item.stays:
            yield removal(item.element)
    if items[-1].stays or last.start != items[-1].element.start:
        if not items[-1].stays:
            yield removal(items[-1].element)
        yield Edit(SourceSpan(last.source, end_of(last), end_of(last)), f"\n\n{text}".rstrip("\n"))
    else:
        yield Edit(lines_of(last), text)


def _in_run(items: tuple[PartItem, ...], whole: object) -> Edit:
    """The edit that puts neighbouring parts, and the comments between them, in the component."""
    first, last = items[0].element, items[-1].element
    indent = indent_of(first)
    span = SourceSpan(first.source, lines_of(first, with_comment=False).start, lines_of(last).end)
    pieces, position = [], span.start
    for item in items:
        own = span_of(item.element)
        pieces += [SourceSpan(first.source, position, own.start).text, indented(item.text, indent).strip()]
        position = own.end
    pieces.append(SourceSpan(first.source, position, span.end).text)
    body = dedented("".join(pieces), indent)
    return Edit(span, whole(body, indent))  # type: ignore[operator]


def _is_run(items: tuple[PartItem, ...], place: Element) -> bool:
    """Whether parts are neighbours, so that what contains them can be written around them."""
    own = [item.element for item in items]
    if any(item.stays for item in items) or any(parent_of(element) is not place for element in own):
        return False
    if lines_of(own[0]).start == own[0].start and len(own) > 1:
        return False
    return all(is_alone(one, other) for one, other in pairwise(own))


def _common(component: Component) -> Element:
    """The innermost element around all parts of a component."""
    chains = [list(ancestors(item.element)) for item in component.items]
    return next(one for one in chains[0] if all(any(one is other for other in chain) for chain in chains[1:]))


def prefix_of(names: Iterable[str]) -> str:
    """Return what the written names of joints begin with, up to the end of its last expression; empty if none."""
    names = list(names)
    shortest = min(names, key=len, default="")
    common = next(
        (shortest[:i] for i in range(len(shortest), 0, -1) if all(n.startswith(shortest[:i]) for n in names)), ""
    )
    found = re.match(r"(.*\})([_/-]?)", common) if "${" in common or "$(" in common else None
    if found is None or found[1].count("{") != found[1].count("}"):
        return ""
    return found[1] + found[2]


def label_of(unit: Element, robot: str) -> str:
    """Return a name for a component: that of its macro, or of the robot."""
    name = attribute(unit, "name") if unit.tagName == MACRO else robot
    short = re.sub(_TRAILING, "", name) or robot
    return re.sub(r"[^A-Za-z0-9_]", "_", short) or "robot"
