"""The graph as a page of its own: hover over a node to see its paths, or search for one."""

from __future__ import annotations

from urdfctl.graph.parts import Graph
from urdfctl.graph.svg import STYLE, svg
from urdfctl.report.common import shown
from urdfctl.report.pages import page


def html(graph: Graph) -> str:
    """Return the page. Its part `graph_part.html.j2` can be included in others, with the same two values."""
    found = [node.rules for node in graph.nodes] + [edge.rules for edge in graph.edges]
    errors = sorted({rule for rules in found for rule in rules})
    return page(
        "graph",
        title=f"{graph.robot or shown(graph.file)}: what is wired to what",
        drawing=svg(graph, style=False),
        styles={"drawing.css": STYLE},
        file=shown(graph.file),
        distro=graph.distro,
        complete=graph.complete,
        errors=errors,
    )
