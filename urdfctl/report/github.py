"""The report as workflow commands, which GitHub Actions shows as annotations in the code.

The form is that of docs.github.com, "Workflow commands for GitHub Actions"; what is escaped, that of actions/toolkit.
"""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic, Severity
from urdfctl.report.common import Report, as_text, rebased, relative, visible
from urdfctl.report.words import paragraph

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}


def render(report: Report) -> str:
    """`::error file=…,line=…,col=…,title=…::message`, a line each, with paths from the root of the checkout."""
    return "".join(f"{_command(relative(diagnostic))}\n" for diagnostic in report.findings)


def _command(diagnostic: Diagnostic) -> str:
    at = diagnostic.at
    properties = {"file": rebased(at.file, "GITHUB_WORKSPACE"), "line": at.line, "endLine": at.end_line}
    if at.end_line == at.line:  # columns of different lines are refused
        properties |= {"col": at.column, "endColumn": at.end_column}
    properties |= {"title": f"{diagnostic.code} {diagnostic.name}"}
    written = ",".join(f"{name}={_property(visible(str(value)))}" for name, value in properties.items())
    said = "\n".join(visible(line) for line in paragraph(diagnostic))
    return f"::{_COMMANDS[diagnostic.severity]} {written}::{_data(said)}"


def _data(text: str) -> str:
    return as_text(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
