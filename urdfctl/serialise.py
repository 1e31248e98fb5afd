"""Diagnostics as JSON, as reports show them and as the worker hands them over."""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic, Location, Remark, Repair, Replacement, Severity, Step
from urdfctl.hints import Any
from urdfctl.lint import Linted, Outcome, SuppressionUse


def linted_to_json(linted: Linted) -> dict[str, Any]:
    """A linted robot as plain data."""
    return {**linted._asdict(), "outcome": outcome_to_json(linted.outcome)}


def linted_from_json(data: dict[str, Any]) -> Linted:
    """The linted robot that plain data stands for."""
    files = {"files": tuple(data["files"]), "controllers": tuple(data["controllers"])}
    arguments = tuple((name, value) for name, value in data["arguments"])
    return Linted(**{**data, **files, "arguments": arguments, "outcome": outcome_from_json(data["outcome"])})


def outcome_to_json(outcome: Outcome) -> dict[str, Any]:
    """An outcome as plain data."""
    return {
        "diagnostics": [diagnostic_to_json(diagnostic) for diagnostic in outcome.diagnostics],
        "suppressions": [[_span(use.at), use.codes, use.used, use.excerpt] for use in outcome.suppressions],
        "crashed": outcome.crashed,
    }


def outcome_from_json(data: dict[str, Any]) -> Outcome:
    """The outcome that plain data stands for."""
    return Outcome(
        [diagnostic_from_json(item) for item in data["diagnostics"]],
        [SuppressionUse(Location(*at), tuple(codes), used, text) for at, codes, used, text in data["suppressions"]],
        data["crashed"],
    )


def diagnostic_to_json(diagnostic: Diagnostic) -> dict[str, Any]:
    """A diagnostic as plain data."""
    fix = diagnostic.fix
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "at": _span(diagnostic.at),
        "expanded_from": [[[s.file, s.line, s.column, s.what] for s in way] for way in diagnostic.expanded_from],
        "notes": [[remark.message, _span(remark.at) if remark.at else None] for remark in diagnostic.notes],
        "fix": [fix.title, fix.safe, [[_span(edit.at), edit.text] for edit in fix.edits]] if fix else None,
        "excerpt": diagnostic.excerpt,
        "url": diagnostic.url,
        "excerpt_column": diagnostic.excerpt_column,
    }


def diagnostic_from_json(data: dict[str, Any]) -> Diagnostic:
    """The diagnostic that plain data stands for."""
    fix = data["fix"]
    return Diagnostic(
        data["code"],
        data["name"],
        Severity(data["severity"]),
        data["message"],
        Location(*data["at"]),
        tuple(tuple(Step(*step) for step in chain) for chain in data["expanded_from"]),
        tuple(Remark(message, Location(*at) if at else None) for message, at in data["notes"]),
        Repair(fix[0], fix[1], tuple(Replacement(Location(*at), text) for at, text in fix[2])) if fix else None,
        data["excerpt"],
        data["url"],
        data["excerpt_column"],
    )


def _span(at: Location) -> list[object]:
    return [at.file, at.line, at.column, at.end_line, at.end_column, at.start, at.end]
