"""`urdfctl graph`: what is wired to what."""

from __future__ import annotations

from collections.abc import Callable

from urdfctl.commands.declaring import OUTPUT, Command, Reads, option
from urdfctl.commands.options import FORMAT, StartOptions
from urdfctl.commands.robot_targets import best_of, robots_of
from urdfctl.commands.words import configured, output_of, settings_to_check
from urdfctl.errors import UserError
from urdfctl.graph.job import graph_for
from urdfctl.graph.parts import Graph
from urdfctl.graph.view import collapsed, focused, readable
from urdfctl.output.printing import print_message, print_text
from urdfctl.output.writing import write_file
from urdfctl.report.common import as_json, shown


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


class GraphOptions(StartOptions):
    """Draw what is wired to what: topics, controllers, interfaces, hardware and joints, with lint's errors in red.

    \b
    Example: urdfctl graph launch/bringup.launch.py --format html=graph.html
    """

    formats: tuple[str, ...] = option(
        OUTPUT, f"{FORMAT} Repeatable. Default: mermaid.", "--format", choices=tuple(FORMATS)
    )
    live: str | None = option(
        OUTPUT,
        "Draw what is wired in a recording of urdfctl doctor --snapshot, with the differences to the files in red.",
        "--live",
        metavar="FILE.json",
        reads=Reads.PLACE,
    )
    focus: tuple[str, ...] = option(
        OUTPUT, "Show only what leads to this joint, controller or topic, or away from it.", metavar="NAME"
    )
    collapse: bool | None = option(
        OUTPUT, "Show joints with the same wiring as one. Default: with more than 30 joints, except in json."
    )


def run_graph(options: GraphOptions) -> int:
    """Print or write the graph, and return the exit status 0."""
    outputs = [output_of(text, FORMATS) for text in options.formats or ("mermaid",)]
    words = options.paths
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
    if options.live is not None:
        graph = _live(graph, options.live)
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


def _live(graph: Graph, path: str) -> Graph:
    from urdfctl.doctor.recording import read_recording
    from urdfctl.doctor.wiring import live_graph

    return live_graph(graph, read_recording(path))


def _reduced(graph: Graph, output: str, *, wanted: bool | None) -> Graph:
    if wanted is None:
        return graph if output == "json" else readable(graph)
    return collapsed(graph) if wanted else graph


command = Command(GraphOptions, run_graph)
