"""Addresses of values in an expanded robot: `joint:elbow/limit/@velocity`, or the file and line where one is written.

A part is a tag with a name (`joint:elbow`), a tag alone for the first child of its kind (`limit`), or a tag with its
number among the children of its kind, from 1 (`visual[2]`). The last part may be an attribute; without one, the address
is of all attributes and the text of an element.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfctl.errors import UserError
from urdfctl.names import did_you_mean, enumerated
from urdfctl.source.disk.files import named_bytes
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.startup.records import NamedTuple

_LINE = r"(.+?):(\d+)(?::(\d+))?"
_MOST_NAMES = 8
HOW = "write joint:NAME/limit/@velocity, or FILE:LINE"


class ValueAddress(NamedTuple):
    """An attribute of an expanded element; its text if `attribute` is empty."""

    element: Element
    attribute: str

    @property
    def text(self) -> str:
        """The value."""
        return self.element.attrs[self.attribute] if self.attribute else text_in(self.element)


class LineAddress(NamedTuple):
    """A line of a file, and a column in it; 0 for the whole line. Both count from 1."""

    file: str
    line: int
    column: int = 0


def line_named(text: str) -> LineAddress | None:
    """Return the line that `FILE:LINE[:COL]` names; None for another text. UserError if the file has no such line."""
    found = re.fullmatch(_LINE, text)
    if found is None or not os.path.isfile(found[1]):
        return None
    number = len(named_bytes(found[1]).splitlines())
    if not 0 < int(found[2]) <= number:
        raise UserError(f"'{found[1]}' has {number} lines, not {found[2]}")
    return LineAddress(os.path.abspath(found[1]), int(found[2]), int(found[3] or 0))


def values_at(root: Element, address: str) -> list[ValueAddress]:
    """Return the values that an address names. UserError if there are none, with what was probably meant."""
    elements, rest = _elements(root, address)
    attribute = rest.removeprefix("@")
    values = [ValueAddress(element, attribute) for element in elements if attribute in element.attrs] if rest else []
    if not rest:
        values = [value for element in elements for value in all_values(element)]
    if not values:
        raise UserError(_unknown_attribute(elements[0], attribute))
    return values


def all_values(element: Element) -> Iterator[ValueAddress]:
    """Yield the attributes of an element, and its text if it has one."""
    yield from (ValueAddress(element, name) for name in element.attrs)
    if text_in(element):
        yield ValueAddress(element, "")


def text_in(element: Element) -> str:
    """Return the text of an element without surrounding blanks."""
    texts = (node.data for node in element.children() if isinstance(node, XmlText) and node.nodeType != COMMENT)
    return "".join(texts).strip()


def address_of(value: ValueAddress) -> str:
    """Return the address of a value."""
    parts = [f"@{value.attribute}"] if value.attribute else []
    element = value.element
    while isinstance(element.parentNode, Element):
        parts.append(_labels(element, element.parentNode)[0])
        element = element.parentNode
    return "/".join(reversed(parts))


def parts_of(element: Element) -> list[Element]:
    """Return an element and those around it, the innermost first, without the root."""
    found = []
    while isinstance(element.parentNode, Element):
        found.append(element)
        element = element.parentNode
    return found


def _name(element: Element) -> str:
    return element.attrs.get("name") or element.attrs.get("reference") or ""


def _labels(element: Element, parent: Element) -> list[str]:
    """The ways to name an element in its parent, the best first."""
    same = [child for child in parent.elements() if child.tagName == element.tagName]
    number = next(index for index, child in enumerate(same, 1) if child is element)
    labels = [f"{element.tagName}:{_name(element)}"] if _name(element) else []
    return [*labels, *([element.tagName] if number == 1 else []), f"{element.tagName}[{number}]"]


def _elements(root: Element, address: str) -> tuple[list[Element], str]:
    """The elements that the parts of an address name, and the attribute that is left of it."""
    elements, rest = [root], address.strip("/")
    while rest and not rest.startswith("@"):
        found = [(child, label) for element in elements for child, label in _matches(element, rest)]
        if not found:
            raise UserError(_unknown_part(elements, rest, is_first=elements[0] is root))
        longest = max(len(label) for _, label in found)
        elements = [child for child, label in found if len(label) == longest]
        rest = rest[longest:].removeprefix("/")
    return elements, rest


def _matches(parent: Element, rest: str) -> Iterator[tuple[Element, str]]:
    tag = re.split(r"[:/\[]", rest, maxsplit=1)[0]
    for child in parent.elements():
        if child.tagName == tag:
            labels = _labels(child, parent)
            yield from ((child, label) for label in labels if rest == label or rest.startswith(f"{label}/"))


def _unknown_part(elements: list[Element], rest: str, *, is_first: bool) -> str:
    part = rest.partition("/")[0]
    tag, colon, name = part.partition(":")
    children = [child for element in elements for child in element.elements()]
    known = dict.fromkeys(child.tagName for child in children)
    if colon and tag in known:
        names = [_name(child) for child in children if child.tagName == tag]
        return f"{tag} '{name}' does not exist{did_you_mean(name, names)}"
    if is_first:
        return f"'{rest}' names no part of the robot{did_you_mean(tag, known)}; {HOW}"
    hint = (
        did_you_mean(part, known) or f"; it has {enumerated([f'<{one}>' for one in known][:_MOST_NAMES]) or 'no parts'}"
    )
    return f"{_described(elements[0])} has no <{part}>{hint}"


def _unknown_attribute(element: Element, attribute: str) -> str:
    hint = did_you_mean(attribute, element.attrs) or f"; it has {enumerated(element.attrs) or 'no attributes'}"
    return (
        f"{_described(element)} has no attribute '{attribute}'{hint}"
        if attribute
        else f"{_described(element)} is empty"
    )


def _described(element: Element) -> str:
    around = next((each for each in parts_of(element) if _name(each)), None)
    if around is element:
        return f"{element.tagName} '{_name(element)}'"
    return f"<{element.tagName}>" + (f" of {around.tagName} '{_name(around)}'" if around is not None else "")
