"""The page of a run, from the results of lint or of smoke."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

from urdfctl.diagnostic import Diagnostic, Location, Severity
from urdfctl.graph.svg import STYLE, svg
from urdfctl.graph.view import readable
from urdfctl.lint.results import Report, TargetResult
from urdfctl.output.printing import visible, visible_in
from urdfctl.page.chart import chart
from urdfctl.page.drawing import drawing
from urdfctl.page.failing import failing_pose
from urdfctl.report.common import relative, shown
from urdfctl.report.pages import page
from urdfctl.smoke.reports import SmokeReport, conditions, explanation, heading, stages_reached, summary
from urdfctl.smoke.results import ControllerResult, RobotResult, Verdict
from urdfctl.startup.records import NamedTuple
from urdfctl.view.html import part_values
from urdfctl.view.job import Portrait

if TYPE_CHECKING:
    from urdfctl.doctor.examination import Ailment
    from urdfctl.doctor.recording import Recording
    from urdfctl.doctor.run import DoctorReport

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
    return _page("Lint", _counted(report.findings) or "no findings", robots, _findings(report.findings, facts), facts)


def doctor_page(report: DoctorReport, recording: Recording, portraits: Sequence[Portrait], facts: RunFacts) -> str:
    """Return the page of a running system: what is wrong in it, what is really wired, and its robots."""
    robots = [
        _robot(_title(result), f"as recorded, beside {shown(report.launch)}", _live(portrait, recording), ())
        for (_, result), portrait in zip(report.robots, portraits, strict=True)
    ]
    ailments = [_ailment(one, facts.folder) for one in report.ailments]
    outcome = _counted(report.ailments) or f"nothing differs from {shown(report.launch)}"
    return _page("Running system", outcome, robots, ailments, facts, fine=report.fine)


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
    outcome = f"{found}; {summary(report)}" if found else summary(report)
    return _page(kind, outcome, robots, _findings(report.found.findings, facts), facts)


def _page(
    kind: str,
    outcome: str,
    robots: list[dict[str, Any]],
    findings: Sequence[dict[str, Any]],
    facts: RunFacts,
    *,
    fine: Sequence[str] = (),
) -> str:
    """The page; findings: the worst first. fine: what is said beside them, as it is as it should be."""
    counts = Counter(one["severity"] for one in findings)
    return page(
        "run",
        title=f"{kind}: {visible(outcome)}",
        kind=kind,
        outcome=visible(outcome),
        worst=findings[0]["severity"] if findings else "passed",
        facts=facts,
        robots=robots,
        findings=findings,
        fine=[visible(each) for each in fine],
        severities=[(one.value, counts[one.value]) for one in Severity if counts[one.value]],
        codes=sorted({one["code"] for one in findings}),
        files=sorted({one["file"] for one in findings if one["file"]}),
        styles={"drawing.css": STYLE},
        in_3d=any(robot["scene"] for robot in robots),
        **part_values(),
    )


def _counted(findings: Sequence[Diagnostic | Ailment]) -> str:
    counts = [(severity, sum(finding.severity is severity for finding in findings)) for severity in Severity]
    return ", ".join(f"{count} {_plural(severity, count)}" for severity, count in counts if count)


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


def _live(portrait: Portrait, recording: Recording) -> Portrait:
    """A portrait with what is really wired in the place of what the files wire."""
    from urdfctl.doctor.wiring import live_graph

    return portrait._replace(graph=live_graph(portrait.graph, recording) if portrait.graph is not None else None)


def _ailment(ailment: Ailment, folder: str) -> dict[str, Any]:
    file = ailment.at.rsplit(":", 2)[0]
    return {
        "code": ailment.code,
        "name": ailment.name,
        "severity": ailment.severity.value,
        "message": visible(ailment.message),
        "at": shown(ailment.at) if ailment.at else "only in the running system",
        "file": shown(file) if file else "",
        "link": _link(file, folder) if file else "",
        "notes": [(visible(note), "") for note in ailment.notes],
        **dict.fromkeys(("before", "marked", "after", "fix"), ""),
        "also": 0,
    }


def _findings(findings: Sequence[Diagnostic], facts: RunFacts) -> list[dict[str, Any]]:
    ordered = sorted(findings, key=lambda finding: (-finding.severity.weight, finding.order))
    return [_finding(relative(finding), _link(finding.at.file, facts.folder)) for finding in ordered]


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


def _pose(result: ControllerResult, robot: RobotResult, moving: set[str]) -> dict[str, Any] | None:
    """The pose at which a controller failed, if the robot in 3-D can take it."""
    if result.verdict not in (Verdict.FAILED, Verdict.WARNED):
        return None
    pose = visible_in(failing_pose(result.name, robot.curves))
    return pose if pose and moving >= pose["positions"].keys() else None


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
                "pose": _pose(result, robot, moving),
            }
            for result in sorted(robot.controllers, key=_rank)
        ],
        "charts": charts,
    }
