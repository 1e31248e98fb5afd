"""Report in GitLab's Code Quality format, which merge requests show beside the code.

Format: docs.gitlab.com, "Code Quality report format".
"""

from __future__ import annotations

import os

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import as_json, as_text, rebased, relative
from urdfctl.report.fingerprint import fingerprints
from urdfctl.report.words import likewise

_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(report: Report) -> str:
    """Return a JSON array of the findings. Paths start at the checkout."""
    prints = fingerprints(report.findings, os.environ.get("CI_PROJECT_DIR") or os.getcwd())
    pairs = zip(report.findings, prints, strict=True)
    return as_json([_issue(relative(diagnostic), mark) for diagnostic, mark in pairs], indent=1) + "\n"


def _issue(diagnostic: Diagnostic, mark: str) -> dict[str, object]:
    at = diagnostic.at
    also = f" ({likewise(diagnostic)})" if diagnostic.also else ""
    return {
        "description": as_text(f"{diagnostic.code} {visible(diagnostic.message + also)}"),
        "check_name": f"{diagnostic.code} {diagnostic.name}",
        "fingerprint": mark,
        "severity": _SEVERITIES[diagnostic.severity],
        "location": {
            "path": as_text(rebased(at.file, "CI_PROJECT_DIR")),
            "lines": {"begin": at.line, "end": at.end_line},
        },
    }
