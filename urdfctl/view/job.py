"""Make the graph and the scene of targets in limited workers."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.graph.build import graph_of
from urdfctl.graph.parts import Graph
from urdfctl.lint.job import Work, Workers, run_on_targets
from urdfctl.lint.target import lint_target
from urdfctl.load.meshes import mesh_path
from urdfctl.load.target import Target
from urdfctl.smoke.robot import mechanism_of
from urdfctl.startup.records import NamedTuple
from urdfctl.view.meshes import installed
from urdfctl.view.outline import Segment, outline_of
from urdfctl.view.planning import planning_of
from urdfctl.view.scene import MOST_TRIANGLES, MeshShelf, scene_of

_SHARE = 0.6
"""Meshes may take this part of the time limit of a robot."""


class Portrait(NamedTuple):
    """What a page shows of a robot.

    graph: what is wired to what; None if it could not be made.
    scene: the robot in 3-D, as plain data; None if it has no links, or meshes were not asked for.
    outline: if there is no scene, the robot at spawn as line segments (x1, y1, z1, x2, y2, z2), in m.
    failure: why there is neither; empty if there is.
    crashed: whether that is a fault of urdfctl.
    """

    graph: Graph | None = None
    scene: dict[str, Any] | None = None
    outline: Sequence[Sequence[float]] = ()
    failure: str = ""
    crashed: bool = False


def portraits(
    targets: Sequence[Target], settings: Settings, *, parallel: int | None = None, in_3d: bool | None = None
) -> Iterator[Portrait]:
    """Yield the portrait of each target, in order.

    in_3d: whether to make scenes; by default if the libraries are installed.
    """
    details = portrait_details(settings, len(targets), in_3d=installed() if in_3d is None else in_3d)
    results = run_on_targets(
        portrait_work, targets, settings, details=[details] * len(targets), workers=Workers(parallel=parallel)
    )
    for result in results:
        if isinstance(result, dict):
            graph = Graph.from_json(result["graph"]) if result["graph"] is not None else None
            yield Portrait(graph, result["scene"], result["outline"])
        else:
            yield Portrait(failure=result.reason, crashed=result.our_fault)


def portrait_details(settings: Settings, count: int = 1, *, in_3d: bool = True) -> dict[str, Any]:
    """Return what `portrait_work` needs for each of `count` targets on a page."""
    return {"in_3d": in_3d, "most": MOST_TRIANGLES // max(1, count), "seconds": settings.timeout * _SHARE}


def portrait_work(work: Work) -> dict[str, Any]:
    """Make a portrait in a worker."""
    began = time.process_time()
    linted = lint_target(work.loader, work.target, work.selection)
    findings = linted.result.outcome.diagnostics
    project = linted.project
    graph = graph_of(project, findings) if project.distros or project.distro else None
    scene = None
    outline: tuple[Segment, ...] = ()
    mechanism = mechanism_of(project.robot) if project.robot is not None else None
    if project.robot is not None and mechanism is not None and not work.details["in_3d"]:
        outline = outline_of(project.robot, mechanism)
    elif work.details["in_3d"] and project.robot is not None and project.robot.links:
        files, packages = work.loader.reading(linted.result.path)
        path = linted.result.path
        shelf = MeshShelf(
            files, lambda address: mesh_path(address, packages, path), began + float(work.details["seconds"])
        )
        scene = scene_of(project.robot, graph, findings, shelf, int(work.details["most"])) | planning_of(project)
    return {"graph": graph.to_json() if graph else None, "scene": scene, "outline": outline}
