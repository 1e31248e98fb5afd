"""The small parts that the model is made of, each with its place."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from urdfctl.source.span import Place

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_LEADING_NUMBER = re.compile(r"\s*[+-]?((\d+\.?\d*|\.\d+)([eE][+-]?\d+)?|inf(inity)?|nan)", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Text:
    """An element that is read for its text.

    `value` is the text as ROS's XML readers give it: blanks around it are cut, and there is none where a comment stands
    before it (then `hidden` is the text that nobody reads).
    """

    value: str
    at: Place
    hidden: str = ""


@dataclass(frozen=True, slots=True)
class Reference:
    """The name of another part, as an element gives it in an attribute; None where the attribute is missing."""

    name: str | None
    at: Place


@dataclass(frozen=True, slots=True)
class Number:
    """A number as it is written."""

    text: str
    at: Place

    @property
    def value(self) -> float | None:
        """The number, if all of the text is one: decimal, without units, commas, inf or nan."""
        return float(self.text) if _NUMBER.fullmatch(self.text.strip()) else None


def leading_number(text: str) -> float | None:
    """What C++'s std::stod reads: the number at the start of a text, whatever follows; None where it throws."""
    found = _LEADING_NUMBER.match(text)
    return float(found.group(0)) if found else None


@dataclass(frozen=True, slots=True)
class Tag:
    """An element that the model has no type of its own for."""

    name: str
    at: Place
    attributes: Mapping[str, str]
    text: str
    children: tuple[Tag, ...] = ()

    def named(self, name: str) -> Iterator[Tag]:
        """The children of a name."""
        return (child for child in self.children if child.name == name)
