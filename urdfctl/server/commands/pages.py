"""Pages that show a robot, made from the open texts, saved or not, in a process of their own."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Mapping

from urdfctl.doctor.recording import Recording, read_recording
from urdfctl.doctor.wiring import live_graph
from urdfctl.errors import UserError
from urdfctl.graph.html import html as graph_html
from urdfctl.graph.job import graph_work
from urdfctl.graph.parts import Graph
from urdfctl.graph.view import readable
from urdfctl.lint.job import Work, WorkFunction, job_for
from urdfctl.load.target import Target
from urdfctl.run.fresh import run_all_fresh
from urdfctl.run.limits import Json, Limits
from urdfctl.server.analysis.workspace import Workspace
from urdfctl.view.html import html as view_html
from urdfctl.view.job import portrait_details, portrait_work


async def graph_page(workspace: Workspace, path: str, recording: str = "") -> str:
    """Return what is wired to what in the robot that says most about a file, as HTML.

    recording: that of a running system, whose differences to the files are shown; empty for the files alone.
    Raises UserError if it has no controllers, or cannot be read.
    """
    live = dict(read_recording(recording).data) if recording else None
    result = await _made(graph_page_work, workspace, workspace.target_with(path), {"live": live})
    if not result["page"]:
        raise UserError(f"the robot of '{os.path.basename(path)}' has no controllers and no hardware to draw")
    return str(result["page"])


async def view_page(workspace: Workspace, path: str) -> str:
    """Return the robot that says most about a file in 3-D, as HTML.

    Raises UserError if the robot cannot be shown. Without the libraries that read meshes it is shown without these.
    """
    details = portrait_details(workspace.settings)
    result = await _made(view_page_work, workspace, workspace.target_with(path), details)
    if not result["page"]:
        raise UserError(f"the robot of '{os.path.basename(path)}' has no links to show")
    return str(result["page"])


async def _made(function: WorkFunction, workspace: Workspace, target: Target, details: Json) -> Json:
    texts = {path: text.decode("utf-8", "surrogatepass") for path, text in dict(workspace.texts).items()}
    job = job_for(function, target, workspace.settings, details={**details, "texts": texts})
    settings = workspace.settings
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    [result] = await asyncio.to_thread(lambda: list(run_all_fresh([job], "urdfctl.lint.job:perform_alone", limits, 1)))
    if not isinstance(result, dict):
        raise UserError(f"'{os.path.basename(target.path)}' cannot be shown: {result.reason}")
    return result


def graph_page_work(work: Work) -> Json:
    """Make the page of a graph in a process."""
    graph = Graph.from_json(graph_work(_with_texts(work)))
    if work.details["live"] is not None:
        graph = live_graph(graph, Recording("", work.details["live"]))
    return {"page": graph_html(readable(graph)) if graph.nodes else ""}


def view_page_work(work: Work) -> Json:
    """Make the page of a robot in 3-D in a process."""
    portrait = portrait_work(_with_texts(work))
    scene, graph = portrait["scene"], portrait["graph"]
    distro = graph["distro"] if graph else ""
    return {"page": view_html(scene, work.target.path, distro) if scene else ""}


def _with_texts(work: Work) -> Work:
    texts: Mapping[str, str] = work.details["texts"]
    overlay = {path: text.encode("utf-8", "surrogatepass") for path, text in texts.items()}
    return work._replace(loader=work.loader.with_overlay(overlay))
