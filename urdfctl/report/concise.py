"""The report with one line a finding, as compilers write it."""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic
from urdfctl.report.common import Report, relative, visible


def render(report: Report) -> str:
    """`file:line:column: severity CODE message`, a line each."""
    return "".join(f"{line(relative(diagnostic))}\n" for diagnostic in report.findings)


def line(diagnostic: Diagnostic) -> str:
    """The one line of a finding."""
    return f"{place(diagnostic)}: {diagnostic.severity.value} {diagnostic.code} {visible(diagnostic.message)}"


def place(diagnostic: Diagnostic) -> str:
    """`file:line:column`."""
    at = diagnostic.at
    return f"{visible(at.file)}:{at.line}:{at.column}"
