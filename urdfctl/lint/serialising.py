"""Encode results as plain data for JSON, as workers send them and reports show them."""

from __future__ import annotations

from typing import Any

from urdfctl.diagnostic import CallStep, Diagnostic, Location, Remark, Repair, Severity, ShownEdit
from urdfctl.lint.results import Outcome, SuppressionUse, TargetResult
from urdfctl.load.bringup import Bringup
from urdfctl.load.join_facts import JoinFacts

_TUPLES = ("files", "controllers", "distros", "nodes", "sections", "missing_packages")


def result_to_json(result: TargetResult) -> dict[str, Any]:
    """Return a target's result as plain data."""
    bringup = result.bringup._asdict() if result.bringup else None
    joining = result.joining._asdict()
    return {**result._asdict(), "outcome": outcome_to_json(result.outcome), "bringup": bringup, "joining": joining}


def result_from_json(data: dict[str, Any]) -> TargetResult:
    """Return the result that `result_to_json` was given."""
    tuples = {name: tuple(data[name]) for name in _TUPLES}
    arguments = tuple((name, value) for name, value in data["arguments"])
    bringup = Bringup.from_json(data["bringup"]) if data["bringup"] else None
    read: dict[str, Any] = {"arguments": arguments, "outcome": outcome_from_json(data["outcome"]), "bringup": bringup}
    read["joining"] = JoinFacts.from_json(data["joining"])
    return TargetResult(**{**data, **tuples, **read})


def outcome_to_json(outcome: Outcome) -> dict[str, Any]:
    """Return an outcome as plain data."""
    return {
        "diagnostics": [diagnostic_to_json(diagnostic) for diagnostic in outcome.diagnostics],
        "suppressions": [[_span(use.at), *use[1:]] for use in outcome.suppressions],
        "crashed": outcome.crashed,
    }


def outcome_from_json(data: dict[str, Any]) -> Outcome:
    """Return the outcome that `outcome_to_json` was given."""
    return Outcome(
        [diagnostic_from_json(item) for item in data["diagnostics"]],
        [SuppressionUse(Location(*at), tuple(codes), *rest) for at, codes, *rest in data["suppressions"]],
        data["crashed"],
    )


def diagnostic_to_json(diagnostic: Diagnostic) -> dict[str, Any]:
    """Return a diagnostic as plain data."""
    fix = diagnostic.fix
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "at": _span(diagnostic.at),
        "expanded_from": [[[s.file, s.line, s.column, s.what] for s in way] for way in diagnostic.expanded_from],
        "notes": [[remark.message, _span(remark.at) if remark.at else None] for remark in diagnostic.notes],
        "fix": [fix.title, fix.safe, [[_span(edit.at), edit.text] for edit in fix.edits], fix.doubt] if fix else None,
        "excerpt": diagnostic.excerpt,
        "url": diagnostic.url,
        "excerpt_column": diagnostic.excerpt_column,
    }


def diagnostic_from_json(data: dict[str, Any]) -> Diagnostic:
    """Return the diagnostic that `diagnostic_to_json` was given."""
    fix = data["fix"]
    return Diagnostic(
        code=data["code"],
        name=data["name"],
        severity=Severity(data["severity"]),
        message=data["message"],
        at=Location(*data["at"]),
        expanded_from=tuple(tuple(CallStep(*step) for step in chain) for chain in data["expanded_from"]),
        notes=tuple(Remark(message, Location(*at) if at else None) for message, at in data["notes"]),
        fix=_repair(*fix) if fix else None,
        excerpt=data["excerpt"],
        url=data["url"],
        excerpt_column=data["excerpt_column"],
    )


def _repair(title: str, safe: bool, edits: list[Any], doubt: str = "") -> Repair:  # noqa: FBT001 (as JSON has it)
    return Repair(title, safe, tuple(ShownEdit(Location(*at), text) for at, text in edits), doubt)


def _span(at: Location) -> list[object]:
    return [at.file, at.line, at.column, at.end_line, at.end_column, at.start, at.end]
