"""A robot as a tree of what ROS reads of it, from which order, blanks and xacro are gone.

Attributes that are missing get the value that their reader takes for them, so that writing a default changes nothing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

from urdfctl.source.xml.dom import COMMENT, Element, XmlText
from urdfctl.startup.records import NamedTuple

_ZERO, _CLOSE = "0 0 0", 1e-9
_DEFAULTS: dict[tuple[str, str], Mapping[str, str]] = {
    ("joint", "origin"): {"xyz": _ZERO, "rpy": _ZERO},
    ("link", "origin"): {"xyz": _ZERO, "rpy": _ZERO},
    ("joint", "axis"): {"xyz": "1 0 0"},
    ("joint", "limit"): {"lower": "0", "upper": "0"},
    ("joint", "mimic"): {"multiplier": "1", "offset": "0"},
    ("joint", "dynamics"): {"damping": "0", "friction": "0"},
    ("link", "mesh"): {"scale": "1 1 1"},
}
"""Default values of urdfdom's parsers, by the part of the robot and the element."""
_IMPLIED = {"joint": ("origin", "axis"), "inertial": ("origin",), "visual": ("origin",), "collision": ("origin",)}
"""Elements that mean the same if they are missing as if they had their defaults."""
_MERGED = frozenset({"gazebo"})
"""Elements of the same name whose contents are read as one."""
_BY_CONTENT = frozenset({"visual", "collision"})
"""Elements whose names nothing refers to: they are the same if their contents are."""


class TreeNode(NamedTuple):
    """A part of a robot.

    tag: the name of its element.
    key: the name that identifies it among its siblings; empty if it has none.
    values: its attributes, with blanks removed; its text under the empty name.
    children: the parts in it.
    """

    tag: str
    key: str
    values: Mapping[str, str]
    children: tuple[TreeNode, ...]

    @property
    def label(self) -> str:
        """Its tag and its name."""
        return f"{self.tag}:{self.key}" if self.key else self.tag

    def to_json(self) -> list[Any]:
        """Return the node as plain data."""
        return [self.tag, self.key, dict(self.values), [child.to_json() for child in self.children]]

    @classmethod
    def from_json(cls, data: list[Any]) -> TreeNode:
        """Return the node that `to_json` made `data` from."""
        return cls(data[0], data[1], data[2], tuple(map(cls.from_json, data[3])))


def node_of(element: Element, shown: Callable[[str], str], part: str = "") -> TreeNode:
    """Return the tree of an element.

    shown: returns a text without the folders that say nothing of the robot.
    part: the kind of the part of the robot that the element is in: `link`, `joint` and so on.
    """
    tag = element.tagName.rpartition(":")[2]
    part = part or ("" if element.parentNode.__class__ is not Element else element.tagName)
    own = (item for item in element.attrs.items() if not item[0].startswith("xmlns"))
    given = {name.rpartition(":")[2]: value for name, value in own}
    values = {name: shown(plain(value)) for name, value in {**_DEFAULTS.get((part, tag), {}), **given}.items()}
    texts = (node.data for node in element.children() if isinstance(node, XmlText) and node.nodeType != COMMENT)
    text = shown(plain(" ".join(texts)))
    if text:
        values[""] = text
    children = [node_of(child, shown, part) for child in element.elements()]
    present = {child.tag for child in children}
    implied = (name for name in _IMPLIED.get(tag, ()) if (part, name) in _DEFAULTS and name not in present)
    children += [TreeNode(name, "", _DEFAULTS[(part, name)], ()) for name in implied]
    key = given.get("name") or given.get("reference") or ""
    return TreeNode(tag, "" if tag in _BY_CONTENT else plain(key), values, merged(children))


def merged(children: list[TreeNode]) -> tuple[TreeNode, ...]:
    """Return parts with those joined that are read as one."""
    found: list[TreeNode] = []
    places: dict[str, int] = {}
    for child in children:
        if child.tag in _MERGED and child.label in places:
            before = found[places[child.label]]
            both = before._replace(values={**before.values, **child.values}, children=before.children + child.children)
            found[places[child.label]] = both
        else:
            places.setdefault(child.label, len(found))
            found.append(child)
    return tuple(found)


def plain(text: str) -> str:
    """Return a text with single blanks between its words, and none around it."""
    return " ".join(text.split())


def is_same(one: str, other: str) -> bool:
    """Return whether two texts are the same, or the same numbers."""
    if one == other:
        return True
    left, right = one.split(), other.split()
    return len(left) == len(right) and all(map(_is_same_word, left, right))


def _is_same_word(one: str, other: str) -> bool:
    if one == other:
        return True
    try:
        return math.isclose(float(one), float(other), rel_tol=_CLOSE, abs_tol=1e-12)
    except ValueError:
        return False
