"""Where the nodes of a graph are on a page: in columns from left to right, near what they are connected with."""

from __future__ import annotations

from collections.abc import Mapping

from urdfctl.graph.parts import KINDS, Graph, GraphNode
from urdfctl.startup.records import NamedTuple

HEIGHT = 24.0
"""The height of a node in pixels."""
LETTER = 7.3
"""The width of a letter in pixels, in a font with a fixed width of 12 px."""
_GAP, _BETWEEN, _MARGIN = 10.0, 70.0, 16.0
_LEAST, _MOST = 60.0, 330.0
_SWEEPS = 4
_MOST_CHAINED = 20


class Box(NamedTuple):
    """A node on the page: the left upper corner and the width, in pixels."""

    node: GraphNode
    x: float
    y: float
    width: float


class Layout(NamedTuple):
    """All nodes by id, and the size of the page, in pixels."""

    boxes: Mapping[str, Box]
    width: float
    height: float


def laid_out(graph: Graph) -> Layout:
    """Return where the nodes of a graph are."""
    columns = _ordered(graph, _columns(graph))
    tallest = max((len(column) for column in columns), default=0)
    height = tallest * (HEIGHT + _GAP) - _GAP + 2 * _MARGIN if tallest else 2 * _MARGIN
    boxes: dict[str, Box] = {}
    x = _MARGIN
    for column in columns:
        width = min(_MOST, max(_LEAST, *(len(node.label) * LETTER + 16 for node in column), 0))
        step = (height - 2 * _MARGIN) / len(column)
        for number, node in enumerate(column):
            boxes[node.id] = Box(node, x, _MARGIN + step * (number + 0.5) - HEIGHT / 2, width)
        x += width + _BETWEEN
    return Layout(boxes, max(x - _BETWEEN + _MARGIN, 2 * _MARGIN), height)


def _columns(graph: Graph) -> list[list[GraphNode]]:
    """The nodes by column. Controllers that others command are to the right of those, and their interfaces between."""
    depths = {node.id: 0 for node in graph.nodes}
    kinds = {node.id: node.kind for node in graph.nodes}
    chained = [edge for edge in graph.edges if {kinds[edge.source], kinds[edge.target]} == {"controller", "command"}]
    for _ in range(min(len(graph.nodes), _MOST_CHAINED)):
        changed = False
        for edge in chained:
            if kinds[edge.source] not in {"controller", "command"} or kinds[edge.target] not in {
                "controller",
                "command",
            }:
                continue
            depth = min(depths[edge.source] + (edge.kind == "commands"), _MOST_CHAINED)
            if depth > depths[edge.target]:
                depths[edge.target], changed = depth, True
        if not changed:
            break
    deepest = max((depths[node.id] for node in graph.nodes if node.kind == "controller"), default=0)
    driven = {edge.source for edge in graph.edges if edge.kind == "drives"}
    columns: dict[tuple[int, int, int], list[GraphNode]] = {}
    for node in graph.nodes:
        place = KINDS.index(node.kind)
        if node.kind in {"controller", "command"}:
            depth = deepest if node.id in driven else depths[node.id]
            key = (KINDS.index("controller"), depth, place)
        else:
            key = (place, 0, 0)
        columns.setdefault(key, []).append(node)
    return [columns[key] for key in sorted(columns)]


def _ordered(graph: Graph, columns: list[list[GraphNode]]) -> list[list[GraphNode]]:
    """The columns with each node near the middle of what it is connected with."""
    beside: dict[str, list[str]] = {node.id: [] for node in graph.nodes}
    for edge in graph.edges:
        beside[edge.source].append(edge.target)
        beside[edge.target].append(edge.source)
    places = _places(columns)
    for sweep in range(_SWEEPS):
        for column in columns if sweep % 2 else reversed(columns):
            middle = {
                node.id: sum(places[other] for other in beside[node.id]) / len(beside[node.id])
                if beside[node.id]
                else places[node.id]
                for node in column
            }
            column.sort(key=lambda node: middle[node.id])
            places.update(_places([column]))
    return columns


def _mean(values: list[float]) -> float:
    return sum(values) / len(values)


def _places(columns: list[list[GraphNode]]) -> dict[str, float]:
    """The place of each node in its column, from 0 to 1."""
    return {node.id: (number + 0.5) / len(column) for column in columns for number, node in enumerate(column)}
