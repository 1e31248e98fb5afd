"""`urdfctl graph`: what is wired to what."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.cli.robot_targets import best_of, robots_of
from urdfctl.cli.words import configured, output_of, settings_to_check
from urdfctl.cli.writing import print_message, print_text, write_file
from urdfctl.errors import UserError
from urdfctl.graph.job import graph_for
from urdfctl.graph.parts import Graph
from urdfctl.graph.view import collapsed, focused, readable
from urdfctl.report.common import as_json, shown
from urdfctl.startup.hints import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfctl.cli.see_options import GraphOptions


def run_graph(options: GraphOptions) -> int:
    """Print or write the graph, and return the exit status 0."""
    outputs = [output_of(text, FORMATS) for text in options.graph_formats or ("mermaid",)]
    words = options.paths or []
    config = configured(words, options)
    settings = settings_to_check(config, options, [word for word in words if ":=" not in word])
    pairs = robots_of(words, config, settings)
    found = best_of(pairs, controlled=True)
    if found is None:
        raise UserError(f"no robot in {', '.join(words) or 'this folder'}")
    others = {result.path for _, result in pairs} - {found[1].path}
    if others:
        print_message(f"drawing {shown(found[1].path)}, one of {len(others) + 1} robots; name another to see that")
    graph = graph_for(found[0], settings)
    for name in options.focus or []:
        graph = focused(graph, name)
    if not graph.nodes:
        raise UserError(f"'{found[0].path}' has no controllers and no hardware; name its launch or controller files")
    for name, file in outputs:
        text = FORMATS[name](_reduced(graph, name, wanted=options.collapse))
        if file is not None:
            write_file(file, text, force=True)
        else:
            print_text(text)
    return 0


def _reduced(graph: Graph, output: str, *, wanted: bool | None) -> Graph:
    if wanted is None:
        return graph if output == "json" else readable(graph)
    return collapsed(graph) if wanted else graph


def _mermaid(graph: Graph) -> str:
    from urdfctl.graph.text_formats import mermaid

    return mermaid(graph)


def _dot(graph: Graph) -> str:
    from urdfctl.graph.text_formats import dot

    return dot(graph)


def _svg(graph: Graph) -> str:
    from urdfctl.graph.svg import svg

    return svg(graph)


def _html(graph: Graph) -> str:
    from urdfctl.graph.html import html

    return html(graph)


def _json(graph: Graph) -> str:
    return as_json(graph.to_json(), 1) + "\n"


FORMATS: dict[str, Callable[[Graph], str]] = {
    "mermaid": _mermaid,
    "dot": _dot,
    "svg": _svg,
    "html": _html,
    "json": _json,
}
