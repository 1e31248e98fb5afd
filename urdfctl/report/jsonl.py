"""Report as JSON Lines: each finding is a line, as in the JSON report. Empty if there are no findings."""

from __future__ import annotations

from urdfctl.lint.results import Report
from urdfctl.report.common import as_json, relative
from urdfctl.report.json_report import finding


def render(report: Report) -> str:
    """Return the findings, one on each line."""
    return "".join(f"{as_json(finding(relative(diagnostic)))}\n" for diagnostic in report.findings)
