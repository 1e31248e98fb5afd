"""The graph as plain data: its nodes and edges."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from urdfctl.startup.records import NamedTuple

KINDS = (
    "group", "input", "controller", "command", "hardware", "joint", "state", "broadcaster", "output", "link", "file",
)  # fmt: skip
"""The kinds of nodes, from left to right."""


class GraphNode(NamedTuple):
    """A part of what is wired.

    id: identifies it in the graph: its kind and its name.
    kind: one of KINDS. `command` and `state` are interfaces, `joint` is also a sensor or gpio; a `link` or a `file` is
      there only if lint reports an error about it that is about no other node.
    name: its full name.
    detail: its type, plugin or interface; empty if there is nothing to add.
    active: False if it is known not to be started, or if nothing uses it.
    rules: the codes of lint's errors about it.
    members: the names of the nodes that it stands for, if there are several.
    """

    id: str
    kind: str
    name: str
    detail: str = ""
    active: bool = True
    rules: tuple[str, ...] = ()
    members: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """What is shown of it: without the package of ROS 1's interfaces, which is always the same."""
        name = self.name.replace("hardware_interface/", "")
        return f"{name} ({len(self.members)})" if self.members else name


class Edge(NamedTuple):
    """A connection.

    source, target: ids of nodes.
    kind: plans, commands, claims (a command interface), drives, moves, measures, reads (a state interface), publishes.
    active: False if one of its ends is not.
    rules: the codes of lint's errors about it.
    """

    source: str
    target: str
    kind: str
    active: bool = True
    rules: tuple[str, ...] = ()


class Graph(NamedTuple):
    """What is wired to what in one robot.

    robot: the robot's name.
    file: the description.
    distro: the distro whose controller manager is meant.
    complete: whether all claims of all controllers are known.
    """

    robot: str
    file: str
    distro: str
    complete: bool
    nodes: tuple[GraphNode, ...]
    edges: tuple[Edge, ...]

    def node(self, key: str) -> GraphNode:
        """Return the node with an id. KeyError if there is none."""
        return {node.id: node for node in self.nodes}[key]

    def among(self, ids: Iterable[str]) -> Graph:
        """Return the graph with only some of its nodes."""
        kept = set(ids)
        nodes = tuple(node for node in self.nodes if node.id in kept)
        return self._replace(
            nodes=nodes, edges=tuple(edge for edge in self.edges if {edge.source, edge.target} <= kept)
        )

    def to_json(self) -> dict[str, Any]:
        """Return the graph as plain data, in the form of graph.schema.json."""
        nodes = [{**node._asdict(), "rules": list(node.rules), "members": list(node.members)} for node in self.nodes]
        edges = [{**edge._asdict(), "rules": list(edge.rules)} for edge in self.edges]
        return {"version": 1, **self._asdict(), "nodes": nodes, "edges": edges}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Graph:
        """Return the graph that `to_json` made `data` from."""
        nodes = tuple(
            GraphNode(**{**node, "rules": tuple(node["rules"]), "members": tuple(node["members"])})
            for node in data["nodes"]
        )
        edges = tuple(Edge(**{**edge, "rules": tuple(edge["rules"])}) for edge in data["edges"])
        rest = {name: value for name, value in data.items() if name not in {"version", "nodes", "edges"}}
        return cls(**rest, nodes=nodes, edges=edges)
