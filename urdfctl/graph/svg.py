"""The graph as a drawing. Its classes and `data-` attributes are what the script of the page works on."""

from __future__ import annotations

from html import escape

from urdfctl.graph.layout import HEIGHT, LETTER, Box, laid_out
from urdfctl.graph.parts import Edge, Graph
from urdfctl.output.printing import visible
from urdfctl.report.common import as_text

STYLE = """
.graph { --node: #fff; --text: #1a1c20; --line: #8a92a0; --quiet: #b9bdc6; --broken: #c22a2f; --group: #7a4bc2;
  --input: #2460c4; --controller: #16794a; --hardware: #9a6200; font: 12px ui-monospace, monospace; }
@media (prefers-color-scheme: dark) { .graph { --node: #1c1f25; --text: #e7e9ee; --line: #7d8592; --quiet: #4a505b;
  --broken: #ff6b6b; --group: #b79aff; --input: #76a9ff; --controller: #4cc38a; --hardware: #e5a83b; } }
.graph rect { fill: var(--node); stroke: var(--line); stroke-width: 1.3; }
.graph text { fill: var(--text); } .graph path { fill: none; stroke: var(--line); stroke-width: 1.2; }
.graph .group rect { stroke: var(--group); } .graph .input rect, .graph .output rect { stroke: var(--input); }
.graph .controller rect, .graph .broadcaster rect { stroke: var(--controller); stroke-width: 2; }
.graph .hardware rect { stroke: var(--hardware); }
.graph .inactive rect, .graph path.inactive { stroke: var(--quiet); } .graph .inactive text { fill: var(--quiet); }
.graph .broken rect { stroke: var(--broken); }
.graph path.broken { stroke: var(--broken); stroke-width: 2; stroke-dasharray: 6 4; }
.graph text.rule { fill: var(--broken); font-size: 10px; } .graph path.reads { stroke-opacity: .45; }
.graph.dimmed .node, .graph.dimmed path, .graph.dimmed .rule { opacity: .12; }
.graph.dimmed .lit { opacity: 1; } .graph .node { cursor: pointer; } .graph .node:focus { outline: none; }
.graph .node:focus rect { stroke-width: 3; }
"""


def svg(graph: Graph, *, style: bool = True) -> str:
    """Return the graph as SVG.

    style: whether its style is in it; a page that embeds several drawings has STYLE once.
    """
    layout = laid_out(graph)
    width, height = f"{layout.width:.0f}", f"{layout.height:.0f}"
    title = _text(f"What is wired to what in {graph.robot or graph.file}")
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" class="graph" {size} role="img" aria-label="{title}">',
        f"<title>{title}</title>",
    ]
    if style:
        lines.append(f"<style>{STYLE}</style>")
    numbers = {node.id: number for number, node in enumerate(graph.nodes)}
    for edge in graph.edges:
        lines += _edge(edge, layout.boxes[edge.source], layout.boxes[edge.target], numbers)
    lines += [_node(layout.boxes[node.id], numbers[node.id]) for node in graph.nodes]
    return as_text("\n".join([*lines, "</svg>"])) + "\n"


def _classes(kind: str, *, active: bool, rules: tuple[str, ...]) -> str:
    return " ".join([kind, *([] if active else ["inactive"]), *(["broken"] if rules else [])])


def _edge(edge: Edge, source: Box, target: Box, numbers: dict[str, int]) -> list[str]:
    start, end = (source.x + source.width, source.y + HEIGHT / 2), (target.x, target.y + HEIGHT / 2)
    bend = max(30.0, abs(end[0] - start[0]) / 2)
    if end[0] < start[0]:  # back to a controller that reads what it controls
        bend = 60.0
    middle = (start[0] + bend, end[0] - bend)
    points = (start, (middle[0], start[1]), (middle[1], end[1]), end)
    corners = [f"{x:.0f} {y:.1f}" for x, y in points]
    path = f"M{corners[0]}C{' '.join(corners[1:])}"
    classes = _classes(edge.kind, active=edge.active, rules=edge.rules)
    ends = f'data-from="{numbers[edge.source]}" data-to="{numbers[edge.target]}" data-kind="{edge.kind}"'
    found = [f'<path class="{classes}" {ends} d="{path}"/>']
    if edge.rules:
        x, y = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2 - 4
        text = _text(" ".join(edge.rules))
        found.append(f'<text class="rule" {ends} x="{x:.0f}" y="{y:.0f}" text-anchor="middle">{text}</text>')
    return found


def _node(box: Box, number: int) -> str:
    node = box.node
    classes = _classes(f"node {node.kind}", active=node.active, rules=node.rules)
    letters = int((box.width - 14) / LETTER)
    shown = visible(node.label)
    label = shown if len(shown) <= letters + 1 else f"{shown[:letters]}…"
    said = [f"{node.kind} {node.name}", node.detail, ", ".join(node.members), *node.rules]
    title = "\n".join(_text(text) for text in said if text)
    rules = _text(" ".join(node.rules))
    radius = HEIGHT / 2 if node.kind in {"joint", "input", "output"} else 4
    return (
        f'<g class="{classes}" data-node="{number}" data-name="{_text(node.name)}" data-rules="{rules}" tabindex="0">'
        f"<title>{title}</title>"
        f'<rect x="{box.x:.0f}" y="{box.y:.1f}" width="{box.width:.0f}" height="{HEIGHT:.0f}" rx="{radius:.0f}"/>'
        f'<text x="{box.x + 8:.0f}" y="{box.y + HEIGHT / 2 + 4:.1f}">{_text(label)}</text></g>'
    )


def _text(text: str) -> str:
    return escape(visible(text))
