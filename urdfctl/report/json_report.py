"""The report as JSON, version 1; its schema is lint.schema.json beside this file."""

from __future__ import annotations

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic, Repair, Severity
from urdfctl.hints import Any
from urdfctl.report.common import Report, as_json, is_robot, relative, shown


def render(report: Report) -> str:
    """The report as one JSON document."""
    return as_json(document(report), indent=1) + "\n"


def document(report: Report) -> dict[str, Any]:
    """The report as plain data."""
    return {
        "version": 1,
        "tool": {"name": "urdfctl", "version": __version__},
        "targets": [
            {
                "robot": shown(target.path) if is_robot(target) else None,
                "controllers": [shown(path) for path in target.controllers],
                "launch": shown(target.launch) if target.launch else None,
                "ros": target.ros,
                "distro": target.distro,
                "distro_from": target.distro_from,
                "simulator": target.simulator,
                "complete": target.complete,
            }
            for target in report.targets
        ],
        "findings": [finding(relative(diagnostic)) for diagnostic in report.findings],
        "summary": {**{severity.value: report.count(severity) for severity in Severity}, "known": report.known},
    }


def finding(diagnostic: Diagnostic) -> dict[str, Any]:
    """One finding as plain data."""
    at = diagnostic.at
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        "file": at.file,
        "line": at.line,
        "column": at.column,
        "end_line": at.end_line,
        "end_column": at.end_column,
        "expanded_from": [
            [{"file": s.file, "line": s.line, "column": s.column, "what": s.what} for s in chain]
            for chain in diagnostic.expanded_from
        ],
        "notes": [
            {"message": note.message}
            | ({"file": note.at.file, "line": note.at.line, "column": note.at.column} if note.at else {})
            for note in diagnostic.notes
        ],
        "fix": _fix(diagnostic.fix),
        "url": diagnostic.url,
    }


def _fix(fix: Repair | None) -> dict[str, Any] | None:
    if fix is None:
        return None
    edits = [{"file": e.file, "start": e.start, "end": e.end, "text": e.text} for e in fix.edits]
    return {"title": fix.title, "safe": fix.safe, "edits": edits}
