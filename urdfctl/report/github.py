"""Report as workflow commands, which GitHub Actions shows as annotations in the code.

Format: docs.github.com, "Workflow commands for GitHub Actions". Escaping: actions/toolkit.
"""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import as_text, rebased, relative
from urdfctl.report.words import paragraph

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def render(report: Report) -> str:
    """Return a line `::error file=…,line=…,col=…,title=…::message` for each finding. Paths start at the checkout.

    Without findings, a plain line for the log of the step says so.
    """
    if not report.findings:
        from urdfctl.report.text import scope

        hidden = f"; {report.known} hidden by the baseline" if report.known else ""
        return as_text(f"no findings in {visible(scope(report))}{hidden}\n")
    return "".join(f"{_command(relative(diagnostic))}\n" for diagnostic in report.findings)


def _command(diagnostic: Diagnostic) -> str:
    at = diagnostic.at
    properties = {"file": rebased(at.file, "GITHUB_WORKSPACE"), "line": at.line, "endLine": at.end_line}
    if at.end_line == at.line:  # GitHub rejects columns if the lines differ
        properties |= {"col": at.column, "endColumn": at.end_column}
    properties |= {"title": f"{diagnostic.code} {diagnostic.name}"}
    parameters = ",".join(f"{name}={_property(visible(str(value)))}" for name, value in properties.items())
    text = "\n".join(visible(line) for line in paragraph(diagnostic))
    return f"::{_COMMANDS[diagnostic.severity]} {parameters}::{_data(text)}"


def _data(text: str) -> str:
    return as_text(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
