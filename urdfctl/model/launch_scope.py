"""What the elements of a ROS 1 launch file are read with: access to other files, and the state of their group."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from urdfctl.model.launch import joined
from urdfctl.source.dom import Document
from urdfctl.startup.records import NamedTuple


class Sources(NamedTuple):
    """Access to files, packages and the environment for a launch file.

    read: returns the tree of a file; None if it cannot be read.
    locate: returns the source path of a file, and whether it exists; None if that cannot be checked.
    find: returns the folder of a package; None if unknown.
    environ: the environment variables.
    blank: returns the value of arguments with an empty default, in this file and the included ones.
    """

    read: Callable[[str], Document | None]
    locate: Callable[[str], tuple[str, bool | None]]
    find: Callable[[str], str | None]
    environ: Mapping[str, str]
    blank: Callable[[], str] = str


class Scope(NamedTuple):
    """The state for the elements of a launch file or group.

    file: path of the launch file.
    namespace: their namespace; UNKNOWN if unknown.
    arguments: the launch arguments by name.
    sure: False if an unknown condition decides whether they are used.
    depth: depth of nested includes.
    in_node: whether they are in a node.
    held: False if they are used only with other launch arguments.
    """

    file: str
    namespace: str
    arguments: dict[str, str]
    sure: bool
    depth: int = 0
    in_node: bool = False
    held: bool = True

    def joined(self, namespace: str) -> str:
        """Return a namespace that is written here, below the namespace of the elements."""
        return joined(self.namespace, namespace)
