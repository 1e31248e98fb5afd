"""The controllers in a YAML file for ROS 1, where each is a map with a type, in maps that are namespaces."""

from __future__ import annotations

from collections.abc import Iterator

from urdfctl.source.yaml import Entry, Mapping, Node, Scalar
from urdfctl.startup.records import NamedTuple

GAINS_OF_GAZEBO = "gazebo_ros_control"


class Item(NamedTuple):
    """A controller, or another map of parameters.

    namespace: the keys above it, joined with slashes; empty at the root.
    parent: the map that it is in.
    type: its type; empty if it is no controller.
    """

    namespace: str
    parent: Mapping
    entry: Entry
    type: str = ""

    @property
    def name(self) -> str:
        """Its key."""
        return self.entry.key.text


def items_of(root: Node) -> Iterator[Item]:
    """Yield the controllers and the other maps in a file, in order."""
    if isinstance(root, Mapping):
        yield from _below(root, "")


def _below(parent: Mapping, namespace: str) -> Iterator[Item]:
    for entry in parent.entries:
        value = entry.value
        kind = type_in(value)
        if kind:
            yield Item(namespace, parent, entry, kind)
        elif isinstance(value, Mapping) and any(item.type for item in _below(value, "")):
            yield from _below(value, f"{namespace}/{entry.key.text}".strip("/"))
        else:
            yield Item(namespace, parent, entry)


def type_in(value: Node) -> str:
    """Return the type of a controller by its parameters; empty if it is no controller."""
    kind = value.get("type") if isinstance(value, Mapping) else None
    return kind.text if isinstance(kind, Scalar) and "/" in kind.text and "::" not in kind.text else ""
