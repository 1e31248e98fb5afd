"""Expands one file as the command `expand` does: in a limited worker, up to the first problem."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfctl.diagnostic import Diagnostic
from urdfctl.hints import Any
from urdfctl.jobs import dead
from urdfctl.lint import Selection, lint
from urdfctl.load import Loader, Target
from urdfctl.model.project import Project
from urdfctl.record import NamedTuple
from urdfctl.serialise import outcome_from_json, outcome_to_json
from urdfctl.settings import Settings
from urdfctl.source.xml_writer import write
from urdfctl.worker import Limits, run


class Expanded(NamedTuple):
    """The text that xacro would write, or None and the problem that ends it; xacro's warnings in both cases."""

    text: str | None
    problems: tuple[Diagnostic, ...]
    crashed: bool = False


def expand_one(path: str, arguments: Mapping[str, str], settings: Settings) -> Expanded:
    """The expansion of one file."""
    target = Target(path, tuple(arguments.items()))
    limits = Limits(settings.timeout, settings.memory, settings.environ)
    job = {"path": path, "arguments": dict(arguments), "settings": settings.to_json()}
    result = next(iter(run([job], perform, limits, 1, fresh="urdfctl.expand:perform")))
    if not isinstance(result, dict):
        outcome = dead(target, settings, result).outcome
        return Expanded(None, tuple(outcome.diagnostics), outcome.crashed)
    outcome = outcome_from_json(result["outcome"])
    return Expanded(result["text"], tuple(outcome.diagnostics), outcome.crashed)


def perform(job: dict[str, Any]) -> dict[str, Any]:
    """Expand the file of a job that came as JSON."""
    path = os.path.abspath(job["path"])
    expander = Loader(Settings.from_json(job["settings"]), Selection()).expander(path, strict=True)
    expansion = expander.expand(path, job["arguments"])
    project = Project(None, path, problems=tuple(expansion.problems), complete=False)
    outcome = lint(project, [], Selection(select=("UC0",)))
    text = write(expansion.document, job["path"]) if expansion.document is not None else None
    return {"text": text, "outcome": outcome_to_json(outcome)}
