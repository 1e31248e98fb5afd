"""The page of a run, from the results of lint or of smoke."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any
from urllib.parse import quote

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.graph.svg import STYLE, svg
from urdfctl.graph.view import readable
from urdfctl.lint.results import Report, TargetResult
from urdfctl.output.printing import visible, visible_in
from urdfctl.page.chart import chart
from urdfctl.page.drawing import drawing
from urdfctl.report.common import relative, shown
from urdfctl.report.pages import page
from urdfctl.smoke.reports import SmokeReport, conditions, explanation, heading, stages_reached, summary
from urdfctl.smoke.results import ControllerResult, RobotResult, Verdict
from urdfctl.startup.records import NamedTuple
from urdfctl.view.html import part_values
from urdfctl.view.job import Portrait

_ORDER = (Verdict.FAILED, Verdict.WARNED, Verdict.SKIPPED, Verdict.PASSED)


class RunFacts(NamedTuple):
    """What the page says of the run itself.

    command: the command line. date: in ISO 8601. seconds: how long it took. folder: that of the page.
    """

    command: str
    date: str
    seconds: float
    folder: str = ""


def lint_page(report: Report, portraits: Sequence[tuple[TargetResult, Portrait]], facts: RunFacts) -> str:
    """Return the page of a lint run."""
    robots = [_robot(_title(result), _how(result), portrait, report.findings) for result, portrait in portraits]
    return _page("Lint", _counted(report.findings) or "no findings", robots, report.findings, facts)


def smoke_page(
    report: SmokeReport, portraits: Sequence[tuple[RobotResult, Portrait]], facts: RunFacts, kind: str = "Smoke test"
) -> str:
    """Return the page of a smoke run, or of one that also lints: what failed comes first."""
    ordered = sorted(portraits, key=lambda pair: min(map(_rank, pair[0].controllers), default=9))
    robots = [
        {**_robot(heading(smoked), conditions(smoked), portrait, report.found.findings), **_tested(smoked, portrait)}
        for smoked, portrait in ordered
    ]
    found = _counted(report.found.findings)
    return _page(
        kind, f"{found}; {summary(report)}" if found else summary(report), robots, report.found.findings, facts
    )


def _page(
    kind: str, outcome: str, robots: list[dict[str, Any]], findings: Sequence[Diagnostic], facts: RunFacts
) -> str:
    ordered = sorted(findings, key=lambda finding: (-finding.severity.weight, finding.order))
    return page(
        "run",
        title=f"{kind}: {visible(outcome)}",
        kind=kind,
        outcome=visible(outcome),
        worst=max(findings, key=lambda finding: finding.severity.weight).severity.value if findings else "passed",
        facts=facts,
        robots=robots,
        findings=[_finding(relative(finding), _link(finding.at.file, facts.folder)) for finding in ordered],
        severities=[(severity.value, count) for severity in Severity if (count := _count(findings, severity))],
        codes=sorted({finding.code for finding in findings}),
        files=sorted({relative(finding).at.file for finding in findings}),
        styles={"drawing.css": STYLE},
        in_3d=any(robot["scene"] for robot in robots),
        **part_values(),
    )


def _counted(findings: Sequence[Diagnostic]) -> str:
    counts = [(severity, _count(findings, severity)) for severity in Severity]
    return ", ".join(f"{count} {_plural(severity, count)}" for severity, count in counts if count)


def _count(findings: Sequence[Diagnostic], severity: Severity) -> int:
    return sum(finding.severity is severity for finding in findings)


def _link(path: str, folder: str) -> str:
    """The address of a file for a page in a folder; empty if it cannot be reached from there."""
    try:
        return quote(os.path.relpath(path, folder or os.getcwd()).replace(os.sep, "/"))
    except ValueError:  # another drive
        return ""


def _with_findings(scene: Any, findings: Sequence[Diagnostic]) -> Any:
    """A scene whose joints have only what the page lists, so that their numbers agree."""
    if not scene:
        return scene
    listed = {finding.code for finding in findings}
    for joint in scene["joints"]:
        joint["findings"] = [one for one in joint.get("findings", ()) if one["code"] in listed]
        joint["error"] = any(one["severity"] == Severity.ERROR.value for one in joint["findings"])
    return scene


def _plural(severity: Severity, count: int) -> str:
    return severity.value if count == 1 or severity is Severity.INFO else f"{severity.value}s"


def _title(result: TargetResult) -> str:
    return heading(RobotResult(result))


def _how(result: TargetResult) -> str:
    parts = [result.distro or " or ".join(result.distros[-2:]), *map(shown, result.controllers)]
    return ", ".join(part for part in parts if part)


def _robot(title: str, facts: str, portrait: Portrait, findings: Sequence[Diagnostic]) -> dict[str, Any]:
    graph = portrait.graph
    if graph is not None:
        graph = readable(graph)
    return {
        "title": visible(title),
        "how": visible(facts),
        "graph": svg(graph, style=False) if graph is not None and graph.nodes else "",
        "scene": visible_in(_with_findings(portrait.scene, findings)),
        "drawing": "" if portrait.scene else drawing(portrait.outline, title),
        "failure": portrait.failure,
        "controllers": [],
        "counts": [],
        "charts": [],
    }


def _finding(finding: Diagnostic, link: str) -> dict[str, Any]:
    at, line = finding.at, finding.excerpt
    start = at.column - finding.excerpt_column
    end = at.end_column - finding.excerpt_column if at.end_line == at.line else len(line)
    return {
        "code": finding.code,
        "name": finding.name,
        "severity": finding.severity.value,
        "message": visible(finding.message),
        "at": f"{at.file}:{at.line}:{at.column}",
        "file": at.file,
        "link": link,
        "before": visible(line[:start].lstrip()),
        "marked": visible(line[start:end]),
        "after": visible(line[end:].rstrip()),
        "notes": [(visible(note.message), _place(note.at)) for note in finding.notes],
        "fix": visible(finding.fix.title) if finding.fix else "",
        "also": len(finding.also),
    }


def _place(at: Location | None) -> str:
    return visible(f"{at.file}:{at.line}:{at.column}") if at is not None else ""


def _rank(result: ControllerResult) -> int:
    return _ORDER.index(result.verdict)


def _tested(robot: RobotResult, portrait: Portrait) -> dict[str, Any]:
    failed = {result.name for result in robot.controllers if result.verdict is Verdict.FAILED}
    moving = {visible(joint["name"]) for joint in portrait.scene["joints"]} if portrait.scene else set()
    charts = [
        visible_in(chart(curve)) for curve in sorted(robot.curves, key=lambda curve: curve.controller not in failed)
    ]
    for one in charts:
        if one["replay"] is not None and one["replay"]["joint"] not in moving:
            one["replay"] = None
    return {
        "counts": [(verdict.value, robot.count(verdict)) for verdict in _ORDER if robot.count(verdict)],
        "controllers": [
            {
                "name": visible(result.name),
                "type": visible(result.type or ""),
                "verdict": result.verdict.value,
                "stages": stages_reached(result, robot.linted.ros).removesuffix(":"),
                "reason": visible(explanation(result)),
            }
            for result in sorted(robot.controllers, key=_rank)
        ],
        "charts": charts,
    }
