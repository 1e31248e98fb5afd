"""Reduce a graph to what fits on a page: the part around a name, and nodes that are wired alike as one."""

from __future__ import annotations

from collections.abc import Sequence

from urdfctl.errors import UserError
from urdfctl.graph.parts import Edge, Graph, GraphNode
from urdfctl.names import did_you_mean, nearest

_ALIKE = ("joint", "command", "state")
_NAMED = 3
_MOST_JOINTS = 30
"""With more joints, drawings show those with the same wiring as one, unless the user says otherwise."""


def readable(graph: Graph) -> Graph:
    """Return a graph as a drawing shows it: joints with the same wiring are one if there are many."""
    joints = sum(node.kind == "joint" for node in graph.nodes)
    return collapsed(graph) if joints > _MOST_JOINTS else graph


def _meant(name: str, known: Sequence[str]) -> str:
    """The hint for an unknown name: a similar one, or one whose last part is similar, such as that of a topic."""
    hint = did_you_mean(name, known)
    if hint:
        return hint
    ends = {one.rpartition("/")[2]: one for one in known if "/" in one.strip("/")}
    meant = nearest(name.rpartition("/")[2], ends)
    return f"; did you mean '{ends[meant]}'?" if meant else ""


def focused(graph: Graph, name: str) -> Graph:
    """Return the part of a graph that leads to a node with a name, or away from it. UserError if there is none."""
    found = {node.id for node in graph.nodes if name in (node.name, node.id, node.name.strip("/"))}
    if not found:
        raise UserError(f"'{name}' is not in the graph{_meant(name, [node.name for node in graph.nodes])}")
    pairs = _ways(graph, found)
    kept = _reached(found, pairs) | _reached(found, [(target, source) for source, target in pairs])
    hubs = {node.id for node in graph.nodes if node.kind == "hardware"}
    through = {edge.target for edge in graph.edges if edge.kind == "drives" and edge.source in kept} & hubs
    return graph.among(kept | through)


def _ways(graph: Graph, start: set[str]) -> list[tuple[str, str]]:
    """The ways of commands and states. Through hardware, a command only reaches its own joint, unless the way begins in
    the hardware; what a controller reads to control does not lead on."""
    joints = _joints(graph)
    kinds = {node.id: node.kind for node in graph.nodes}
    found = [(key, joint) for key, joint in joints.items() if kinds[key] == "command"]
    for edge in graph.edges:
        is_hub = edge.kind in {"drives", "moves"} and not {edge.source, edge.target} & start
        is_feedback = edge.kind == "reads" and kinds[edge.target] != "broadcaster"
        if not is_hub and not is_feedback:
            found.append((edge.source, edge.target))
    return found


def _reached(start: set[str], pairs: list[tuple[str, str]]) -> set[str]:
    neighbours: dict[str, list[str]] = {}
    for source, target in pairs:
        neighbours.setdefault(source, []).append(target)
    seen, pending = set(start), list(start)
    while pending:
        for other in neighbours.get(pending.pop(), ()):
            if other not in seen:
                seen.add(other)
                pending.append(other)
    return seen


def collapsed(graph: Graph) -> Graph:
    """Return a graph in which joints with the same wiring are one node, and so are their interfaces."""
    around: dict[str, list[tuple[str, ...]]] = {node.id: [] for node in graph.nodes}
    nodes = {node.id: node for node in graph.nodes}
    for edge in graph.edges:
        for own, other, way in ((edge.source, edge.target, "to"), (edge.target, edge.source, "from")):
            kind = nodes[other].kind
            what = nodes[other].detail if kind in _ALIKE else other
            around[own].append((way, kind, what, str(edge.active), *edge.rules))
    joint_of = _joints(graph)
    groups: dict[tuple[object, ...], list[GraphNode]] = {}
    for node in graph.nodes:
        if node.kind in _ALIKE:
            # interfaces belong together if their joints do
            joint = joint_of.get(node.id, "")
            alike = (*sorted(around[node.id]), *sorted(around.get(joint, [])))
            groups.setdefault((node.kind, node.detail, node.active, node.rules, alike), []).append(node)
    merged: dict[str, GraphNode] = {}
    for members in groups.values():
        one = members[0] if len(members) == 1 else _one_of(members)
        merged.update({node.id: one for node in members})
    kept = dict.fromkeys(merged.get(node.id, node) for node in graph.nodes)
    edges: dict[tuple[str, str], Edge] = {}
    for edge in graph.edges:
        source, target = (merged[end].id if end in merged else end for end in (edge.source, edge.target))
        edges.setdefault((source, target), edge._replace(source=source, target=target))
    return graph._replace(nodes=tuple(kept), edges=tuple(edges.values()))


def _joints(graph: Graph) -> dict[str, str]:
    """The joint of each interface: its name is before the interface in the name."""
    known = {node.id for node in graph.nodes if node.kind == "joint"}
    pairs = (
        (node.id, f"joint:{node.name.removesuffix(f'/{node.detail}')}")
        for node in graph.nodes
        if node.kind in {"command", "state"}
    )
    return {key: joint for key, joint in pairs if joint in known}


def _one_of(members: list[GraphNode]) -> GraphNode:
    first = members[0]
    names = [node.name.removesuffix(f"/{first.detail}") if first.kind != "joint" else node.name for node in members]
    shown = ", ".join(names[:_NAMED]) + (f" and {len(names) - _NAMED} more" if len(names) > _NAMED else "")
    name = shown if first.kind == "joint" else f"{first.detail} of {shown}"
    return first._replace(name=name, members=tuple(node.name for node in members))
