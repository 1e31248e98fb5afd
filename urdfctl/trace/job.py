"""Answer a question about a robot in a limited worker."""

from __future__ import annotations

from typing import Any

from urdfctl.config.settings import Settings
from urdfctl.errors import UserError
from urdfctl.lint.job import Work, run_on_targets
from urdfctl.load.target import Target
from urdfctl.source.span import SourceSpan, SourceText
from urdfctl.trace.address import LineAddress, ValueAddress, all_values, values_at
from urdfctl.trace.answer import answer, depends_on
from urdfctl.trace.loading import Traced, traced
from urdfctl.trace.uses import uses_of

_MOST_VALUES = 50
"""So many values are answered in full; of a line that more depend on, the others are only counted."""

Json = dict[str, Any]


def why(target: Target, settings: Settings, what: str | LineAddress) -> Json:
    """Return the answer as plain data: its `values`, the number of `more` values, and the robot's file.

    what: an address, or a line of a file.
    Raises UserError if the robot cannot be expanded or has no such value, RuntimeError if urdfctl crashed.
    """
    details = {"address": what} if isinstance(what, str) else {"line": list(what)}
    [result] = run_on_targets(why_work, [target], settings, details=[details])
    if not isinstance(result, dict):
        if result.our_fault:
            raise RuntimeError(result.reason)
        raise UserError(f"'{target.path}' cannot be traced: {result.reason}")
    if "error" in result:
        raise UserError(result["error"])
    return result


def why_work(work: Work) -> Json:
    """Answer a question in a worker."""
    found = traced(work.loader.settings, work.target)
    if found is None:
        return {"error": f"'{work.target.path}' cannot be expanded; to see why, run: urdfctl lint {work.target.path}"}
    try:
        values = _values(found, work.details)
    except UserError as error:
        return {"error": str(error)}
    project = found.loaded.project
    arguments = dict(found.loaded.arguments)
    answers = [_answered(found, value) for value in values[:_MOST_VALUES]]
    more = len(values) - len(answers)
    return {"version": 1, "file": project.path, "arguments": arguments, "values": answers, "more": more}


def _answered(found: Traced, value: ValueAddress) -> Json:
    project = found.loaded.project
    uses = [use.as_json() for use in uses_of(project, value.element)]
    return {**answer(found.recorder, value, project.launch), "used_by": uses}


def _values(found: Traced, details: Json) -> list[ValueAddress]:
    if "address" in details:
        return values_at(found.root, details["address"])
    line = LineAddress(*details["line"])
    source = found.loaded.sources.get(line.file)
    if source is None:
        raise UserError(f"'{line.file}' is not read for '{found.loaded.project.path}'")
    span = _span_of(source, line)
    values = [
        value
        for element in found.root.walk()
        for value in all_values(element)
        if depends_on(found.recorder, value, span)
    ]
    if not values:
        raise UserError(f"no value of the robot depends on {line.file}:{line.line}")
    return values


def _span_of(source: SourceText, line: LineAddress) -> SourceSpan:
    """The span of a line without its indentation, or of the character in a column."""
    if line.column:
        start = source.offset(line.line, line.column)
        return SourceSpan(source, start, start + 1)
    text = source.line(line.line)
    start = source.offset(line.line, len(text) - len(text.lstrip()) + 1)
    return SourceSpan(source, start, start + len(text.strip().encode()))
