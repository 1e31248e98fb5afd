"""The graph in languages that other programs draw: Mermaid, which GitHub renders, and Graphviz's DOT."""

from __future__ import annotations

from urdfctl.graph.parts import Edge, Graph, GraphNode
from urdfctl.output.printing import visible

_SHAPES = {
    "group": ("[[", "]]"), "input": ("([", "])"), "controller": ("[", "]"), "command": ("(", ")"),
    "hardware": ("{{", "}}"), "joint": ("((", "))"), "state": ("(", ")"), "broadcaster": ("[", "]"),
    "output": ("([", "])"), "link": ("[", "]"), "file": ("[", "]"),
}  # fmt: skip
_ENTITIES = {letter: f"#{ord(letter)};" for letter in '"#&<>;[]{}()|\\`'}
_DOT_SHAPES = {
    "hardware": "hexagon",
    "joint": "ellipse",
    "group": "component",
    "input": "cds",
    "output": "cds",
    "file": "note",
}


def mermaid(graph: Graph) -> str:
    """Return the graph as a flowchart of Mermaid."""
    keys = {node.id: f"n{number}" for number, node in enumerate(graph.nodes)}
    lines = ["flowchart LR"]
    for node in graph.nodes:
        before, after = _SHAPES[node.kind]
        lines.append(f'  {keys[node.id]}{before}"{_mermaid_text(node)}"{after}')
    lines += [f"  {keys[edge.source]} {_arrow(edge)} {keys[edge.target]}" for edge in graph.edges]
    for name, style in (
        ("inactive", "fill:#ececef,stroke:#b9bdc6,color:#777d88"),
        ("broken", "stroke:#c22a2f,stroke-width:2px"),
    ):
        found = [keys[node.id] for node in graph.nodes if (node.rules if name == "broken" else not node.active)]
        if found:
            lines += [f"  classDef {name} {style}", f"  class {','.join(found)} {name}"]
    broken = [str(number) for number, edge in enumerate(graph.edges) if edge.rules]
    if broken:
        lines.append(f"  linkStyle {','.join(broken)} stroke:#c22a2f,stroke-dasharray:5 4")
    grey = [str(number) for number, edge in enumerate(graph.edges) if not edge.active and not edge.rules]
    if grey:
        lines.append(f"  linkStyle {','.join(grey)} stroke:#b9bdc6")
    return "\n".join(lines) + "\n"


def _mermaid_text(node: GraphNode) -> str:
    texts = [node.label, *([node.detail] if _has_detail(node) else []), " ".join(node.rules)]
    return "<br/>".join("".join(_ENTITIES.get(letter, letter) for letter in visible(text)) for text in texts if text)


def _arrow(edge: Edge) -> str:
    if edge.rules:
        return f'-. "{" ".join(edge.rules)}" .->'
    return "-->" if edge.active else "-.->"


def _has_detail(node: GraphNode) -> bool:
    """Whether the detail of a node is shown: that of an interface is in its name already."""
    return bool(node.detail) and node.kind not in {"command", "state", "input", "output"}


def dot(graph: Graph) -> str:
    """Return the graph in DOT, for Graphviz."""
    lines = [
        f"digraph {_quoted(graph.robot or 'robot')} {{",
        '  rankdir=LR; node [shape=box, fontname="sans-serif", fontsize=10]; edge [fontname="sans-serif", fontsize=9];',
    ]
    for node in graph.nodes:
        texts = [node.label, *([node.detail] if _has_detail(node) else []), " ".join(node.rules)]
        style = f", shape={_DOT_SHAPES[node.kind]}" if node.kind in _DOT_SHAPES else ""
        style += ', color="#c22a2f"' if node.rules else "" if node.active else ', color="#b9bdc6", fontcolor="#777d88"'
        label = "\\n".join(_escaped(text) for text in texts if text)
        lines.append(f'  {_quoted(node.id)} [label="{label}"{style}];')
    for edge in graph.edges:
        style = ' [color="#b9bdc6"]' if not edge.active else ""
        if edge.rules:
            style = f' [style=dashed, color="#c22a2f", fontcolor="#c22a2f", label="{_escaped(" ".join(edge.rules))}"]'
        lines.append(f"  {_quoted(edge.source)} -> {_quoted(edge.target)}{style};")
    return "\n".join([*lines, "}"]) + "\n"


def _quoted(text: str) -> str:
    return f'"{_escaped(text)}"'


def _escaped(text: str) -> str:
    return visible(text.replace("\n", " ")).replace("\\", "\\\\").replace('"', '\\"')
