"""The report as JSON Lines: one finding a line, as the JSON report has it; nothing where nothing was found."""

from __future__ import annotations

from urdfctl.report.common import Report, as_json, relative
from urdfctl.report.json_report import finding


def render(report: Report) -> str:
    """The findings, a line each."""
    return "".join(f"{as_json(finding(relative(diagnostic)))}\n" for diagnostic in report.findings)
