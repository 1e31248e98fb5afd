"""Make the graph of a target in a limited worker."""

from __future__ import annotations

from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.graph.build import graph_of
from urdfctl.graph.parts import Graph
from urdfctl.lint.job import Work, run_on_targets
from urdfctl.lint.target import lint_target
from urdfctl.load.target import Target


def graph_for(target: Target, settings: Settings) -> Graph:
    """Return the graph of a target. UserError if it cannot be loaded, RuntimeError if urdfctl crashed."""
    [result] = run_on_targets(graph_work, [target], settings)
    if not isinstance(result, dict):
        if result.our_fault:
            raise RuntimeError(result.reason)
        raise UserError(f"'{target.path}' has no graph: {result.reason}")
    return Graph.from_json(result)


def graph_work(work: Work) -> dict[str, Any]:
    """Make a graph in a worker."""
    linted = lint_target(work.loader, work.target, work.selection)
    return graph_of(linted.project, linted.result.outcome.diagnostics).to_json()
