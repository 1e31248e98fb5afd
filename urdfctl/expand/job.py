"""Expand one file in a limited worker, up to the first problem."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.diagnostic import Diagnostic
from urdfctl.expand.xml_writer import write
from urdfctl.lint.engine import lint
from urdfctl.lint.job import Work, run_on_one
from urdfctl.lint.selection import Selection
from urdfctl.lint.serialising import outcome_to_json
from urdfctl.load.target import Target
from urdfctl.model.project import Project
from urdfctl.startup.records import NamedTuple


class ExpandedText(NamedTuple):
    """The expanded text.

    text: None if a problem ended the expansion.
    problems: that problem, and xacro's warnings.
    crashed: True if urdfctl itself failed.
    """

    text: str | None
    problems: tuple[Diagnostic, ...]
    crashed: bool = False


def expand_file(path: str, arguments: Mapping[str, str], settings: Settings) -> ExpandedText:
    """Return the expansion of one file."""
    target = Target(path, tuple(arguments.items()))
    result, outcome = run_on_one(expand_work, target, settings)
    if result is None:
        return ExpandedText(None, tuple(outcome.diagnostics), outcome.crashed)
    return ExpandedText(result["text"], tuple(outcome.diagnostics), outcome.crashed)


def expand_work(work: Work) -> dict[str, Any]:
    """Expand a file in a worker."""
    path = os.path.abspath(work.target.path)
    expansion = work.loader.expander(path, strict=True).expand(path, dict(work.target.arguments))
    project = Project(None, path, problems=tuple(expansion.problems), complete=False)
    outcome = lint(project, [], Selection(select=("UC0",)))
    text = write(expansion.document, work.target.path) if expansion.document is not None else None
    return {"text": text, "outcome": outcome_to_json(outcome)}
