"""Small located parts of the model: texts, references, numbers, comments and generic elements."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from urdfctl.source.span import Place
from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.startup.records import NamedTuple

_NUMBER = r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?"
_LEADING_NUMBER = r"(?i)\s*[+-]?((\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|inf(inity)?|nan)"


class ElementText(NamedTuple):
    """The text of an element.

    value: the text as ROS's XML readers return it, without surrounding blanks; empty if a comment precedes it.
    at: the element.
    hidden: the text after a comment, which these readers miss.
    padded: whether blanks surround the text.
    """

    value: str
    at: Place
    hidden: str = ""
    padded: bool = False

    @property
    def past_comments(self) -> str:
        """The text as ROS 2's reader returns it: tinyxml2 from version 9 on skips comments before the text."""
        return self.value or self.hidden


class PartReference(NamedTuple):
    """A reference to another part by name, in an attribute.

    name: the name; None if the attribute is missing.
    element: the element with the attribute.
    attribute: name of the attribute.
    """

    name: str | None
    element: Place
    attribute: str

    @property
    def at(self) -> Place:
        """The place of the name; the element if the attribute is missing."""
        return self.element[self.attribute]


class Number(NamedTuple):
    """A number or several numbers in an attribute.

    text: the value of the attribute.
    element: the element with the attribute.
    attribute: name of the attribute.
    """

    text: str
    element: Place
    attribute: str

    @property
    def at(self) -> Place:
        """The place of the attribute's value."""
        return self.element[self.attribute]

    @property
    def value(self) -> float | None:
        """The number, if the whole text is one decimal number; None for units, commas, inf or nan."""
        return _number(self.text)


@lru_cache(8192)
def _number(text: str) -> float | None:
    """The number, cached: robots repeat a few numbers many times, and several rules ask for each."""
    return float(text) if re.fullmatch(_NUMBER, text.strip()) else None


def leading_number(text: str) -> float | None:
    """Return the number at the start of a text, whatever follows, like C++'s std::stod; None where that throws."""
    match = re.match(_LEADING_NUMBER, text)
    return float(match.group(0)) if match else None


class Comment(NamedTuple):
    """A comment; `at` is the preceding or enclosing element if the source does not contain the comment literally."""

    text: str
    at: Place


class Tag:
    """A read-only view of any element, for elements without a type of their own in the model."""

    __slots__ = ("_children", "_element", "attributes", "name")

    def __init__(self, element: Element) -> None:
        self._element = element
        self._children: tuple[Tag, ...] | None = None
        self.name = element.tagName
        self.attributes: Mapping[str, str] = element.attrs

    @property
    def at(self) -> Place:
        """The place of the element."""
        return self._element.at

    @property
    def text(self) -> str:
        """The text, like `Text.value`."""
        return text_of(self._element).value

    @property
    def past_comments(self) -> str:
        """The text, like `Text.past_comments`."""
        return text_of(self._element).past_comments

    @property
    def children(self) -> tuple[Tag, ...]:
        """The child elements, in order."""
        if self._children is None:
            self._children = tuple([Tag(child) for child in self._element.elements()])
        return self._children

    def comments(self) -> Iterator[Comment]:
        """Return the comments in the element, at any depth, in order."""
        return _comments(self._element)

    def named(self, name: str) -> Iterator[Tag]:
        """Return the children with a name."""
        return (child for child in self.children if child.name == name)


def text_of(element: Element) -> ElementText:
    """Return the text of an element, as ROS's XML readers see it."""
    first, comment = element.firstChild, False
    while isinstance(first, XmlText):
        if first.nodeType == COMMENT:
            comment = True
        elif first.data.strip():
            value = first.data.strip()
            padded = len(value) < len(first.data)
            return (
                ElementText("", element.at, value, padded) if comment else ElementText(value, element.at, padded=padded)
            )
        first = first.nextSibling
    return ElementText("", element.at)


def texts_of(element: Element, name: str) -> tuple[ElementText, ...]:
    """Return the texts of an element's children with a name."""
    return tuple(text_of(child) for child in element.elements() if child.tagName == name)


def _comments(element: Element) -> Iterator[Comment]:
    pending = [(element, element.children())]
    while pending:
        after, nodes = pending.pop()
        for node in nodes:
            if isinstance(node, Element):
                pending += [(node, nodes), (node, node.children())]
                break
            if isinstance(node, XmlText) and node.nodeType == COMMENT:
                yield Comment(node.data, _place_of(node.data, after))


def _place_of(comment: str, after: Element) -> Place:
    """The place of a comment that follows the start tag of an element."""
    written = f"<!--{comment}-->".encode()
    start = after.source.data.find(written, after.start)
    return Place(after.source, start, after.call, end=start + len(written)) if start >= 0 else after.at
