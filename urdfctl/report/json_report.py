"""Report as JSON, version 1. Its schema is lint.schema.json in this folder."""

from __future__ import annotations

from typing import Any

from urdfctl import __version__
from urdfctl.diagnostic import Diagnostic, Remark, Repair, Severity
from urdfctl.lint.results import Report, TargetResult, Unjoined
from urdfctl.load.bringup import Bringup
from urdfctl.report.common import as_json, is_robot, relative, shown


def render(report: Report) -> str:
    """Return the report as a JSON document."""
    return as_json(document(report), indent=1) + "\n"


def document(report: Report) -> dict[str, Any]:
    """Return the report as plain data."""
    return {
        "version": 1,
        "tool": {"name": "urdfctl", "version": __version__},
        "targets": [target_document(target) for target in report.targets],
        "unused": [shown(path) for path in report.unused],
        "unjoined": [unjoined_document(each) for each in report.unjoined],
        "missing_packages": list(report.missing_packages),
        "findings": [finding(relative(diagnostic)) for diagnostic in report.findings],
        "summary": {**{severity.value: report.count(severity) for severity in Severity}, "known": report.known},
    }


def target_document(target: TargetResult) -> dict[str, Any]:
    """Return a target as plain data."""
    bringup = target.bringup or Bringup()
    return {
        "robot": shown(target.path) if is_robot(target) else None,
        "arguments": dict(target.arguments),
        "controllers": [shown(path) for path in target.controllers],
        "launch": shown(target.launch) if target.launch else None,
        "launch_arguments": dict(bringup.arguments),
        "arguments_from": shown(bringup.told_at) if bringup.told_at else None,
        "beside": [shown(path) for path in bringup.beside],
        "includes": [shown(path) for path in bringup.includes],
        "namespace": bringup.namespace,
        "spawned": list(bringup.spawned),
        "moveit": bringup.moveit,
        "ros": target.ros,
        "distro": target.distro,
        "distro_from": target.distro_from,
        "simulator": target.started_simulator,
        "complete": target.complete,
    }


def unjoined_document(unjoined: Unjoined) -> dict[str, Any]:
    """Return a launch file that starts controllers without a robot, or what is not here, as plain data."""
    robot = shown(unjoined.robot) if unjoined.robot else None
    lacks: dict[str, Any] = {
        "joints": list(unjoined.joints),
        "controllers": list(unjoined.controllers),
        "packages": list(unjoined.packages),
    }
    lacks |= {"description": shown(unjoined.description)} if unjoined.description else {}
    lacks |= {"models": list(map(shown, unjoined.models))} if unjoined.models else {}
    lacks |= {"included": shown(unjoined.gone[0])} if unjoined.gone else {}
    lacks |= {"variables": list(unjoined.variables)} if unjoined.variables else {}
    return {"launch": shown(unjoined.path), "robot": robot, "lacks": lacks}


def finding(diagnostic: Diagnostic) -> dict[str, Any]:
    """Return a finding as plain data."""
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
        "also": [_remark(remark) for remark in diagnostic.also],
        "notes": [_remark(note) for note in diagnostic.notes],
        "fix": _fix(diagnostic.fix),
        "url": diagnostic.url,
    }


def _remark(remark: Remark) -> dict[str, Any]:
    at = {"file": remark.at.file, "line": remark.at.line, "column": remark.at.column} if remark.at else {}
    return {"message": remark.message, **at}


def _fix(fix: Repair | None) -> dict[str, Any] | None:
    if fix is None:
        return None
    edits = [{"file": e.file, "start": e.start, "end": e.end, "text": e.text} for e in fix.edits]
    doubt = {"doubt": fix.reason} if fix.reason else {}
    return {"title": fix.title, "safe": fix.safe, **doubt, "edits": edits}
