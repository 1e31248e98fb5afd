"""The small parts that the model is made of, each with its place."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from urdfctl.record import NamedTuple
from urdfctl.source.dom import COMMENT, Element
from urdfctl.source.dom import Text as Characters
from urdfctl.source.span import Place

_NUMBER = r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?"
_LEADING_NUMBER = r"(?i)\s*[+-]?((\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|inf(inity)?|nan)"


class Text(NamedTuple):
    """An element that is read for its text.

    `value` is the text as ROS's XML readers give it: blanks around it are cut, and there is none where a comment stands
    before it (then `hidden` is the text that nobody reads). `padded` tells that blanks stand around it.
    """

    value: str
    at: Place
    hidden: str = ""
    padded: bool = False

    @property
    def past_comments(self) -> str:
        """The text as ROS 2's reader gives it, which passes over comments before it (tinyxml2 from 9 on)."""
        return self.value or self.hidden


class Reference(NamedTuple):
    """The name of another part, as an element gives it in an attribute; None where the attribute is missing."""

    name: str | None
    element: Place
    attribute: str

    @property
    def at(self) -> Place:
        """Where the name stands; the element where it is missing."""
        return self.element[self.attribute]


class Number(NamedTuple):
    """A number, or several, as an attribute gives them."""

    text: str
    element: Place
    attribute: str

    @property
    def at(self) -> Place:
        """Where the attribute's value stands."""
        return self.element[self.attribute]

    @property
    def value(self) -> float | None:
        """The number, if all of the text is one: decimal, without units, commas, inf or nan."""
        return _number(self.text)


@lru_cache(8192)
def _number(text: str) -> float | None:
    """Robots say the same few numbers again and again, and rules ask for each more than once."""
    return float(text) if re.fullmatch(_NUMBER, text.strip()) else None


def leading_number(text: str) -> float | None:
    """What C++'s std::stod reads: the number at the start of a text, whatever follows; None where it throws."""
    found = re.match(_LEADING_NUMBER, text)
    return float(found.group(0)) if found else None


class Comment(NamedTuple):
    """A comment; where the source does not write it literally, `at` is the element that it stands in."""

    text: str
    at: Place


class Tag:
    """An element that the model has no type of its own for: a view of the tree, which is never changed through it."""

    __slots__ = ("_children", "_element", "attributes", "name")

    def __init__(self, element: Element) -> None:
        self._element = element
        self._children: tuple[Tag, ...] | None = None
        self.name = element.tagName
        self.attributes: Mapping[str, str] = element.attrs

    @property
    def at(self) -> Place:
        """Where the element stands."""
        return self._element.at

    @property
    def text(self) -> str:
        """The text, as `Text.value` has it."""
        return text_of(self._element).value

    @property
    def past_comments(self) -> str:
        """The text, as `Text.past_comments` has it."""
        return text_of(self._element).past_comments

    @property
    def children(self) -> tuple[Tag, ...]:
        """The elements in it, in order."""
        if self._children is None:
            self._children = tuple([Tag(child) for child in self._element.elements()])
        return self._children

    def comments(self) -> Iterator[Comment]:
        """The comments below it, in order."""
        return _comments(self._element)

    def named(self, name: str) -> Iterator[Tag]:
        """The children of a name."""
        return (child for child in self.children if child.name == name)


def text_of(element: Element) -> Text:
    """The text of an element, as ROS's XML readers give it."""
    first, comment = element.firstChild, False
    while isinstance(first, Characters):
        if first.nodeType == COMMENT:
            comment = True
        elif first.data.strip():
            value = first.data.strip()
            padded = len(value) < len(first.data)
            return Text("", element.at, value, padded) if comment else Text(value, element.at, padded=padded)
        first = first.nextSibling
    return Text("", element.at)


def texts_of(element: Element, name: str) -> tuple[Text, ...]:
    """The texts of an element's children of one name."""
    return tuple(text_of(child) for child in element.elements() if child.tagName == name)


def _comments(element: Element) -> Iterator[Comment]:
    pending = [(element, element.children())]
    while pending:
        after, nodes = pending.pop()
        for node in nodes:
            if isinstance(node, Element):
                pending += [(node, nodes), (node, node.children())]
                break
            if isinstance(node, Characters) and node.nodeType == COMMENT:
                yield Comment(node.data, _place_of(node.data, after))


def _place_of(comment: str, after: Element) -> Place:
    """Where a comment stands that follows the start tag of an element."""
    written = f"<!--{comment}-->".encode()
    start = after.source.data.find(written, after.start)
    return Place(after.source, start, after.call, end=start + len(written)) if start >= 0 else after.at
