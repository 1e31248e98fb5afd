"""The report with one line a finding, as compilers write it."""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic
from urdfctl.report.common import Report, relative


def render(report: Report) -> str:
    """`file:line:column: severity CODE message`, a line each."""
    return "".join(f"{line(relative(diagnostic))}\n" for diagnostic in report.findings)


def line(diagnostic: Diagnostic) -> str:
    """The one line of a finding."""
    at = diagnostic.at
    return f"{at.file}:{at.line}:{at.column}: {diagnostic.severity.value} {diagnostic.code} {diagnostic.message}"
