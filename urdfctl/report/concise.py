"""Report with one line for each finding, as compilers print it."""

from __future__ import annotations

from urdfctl.diagnostic import Diagnostic
from urdfctl.lint.results import Report
from urdfctl.output.printing import visible
from urdfctl.report.common import counted, relative
from urdfctl.report.words import likewise


def render(report: Report) -> str:
    """Return a line `file:line:column: severity CODE message` for each finding, and the statistics if asked for."""
    lines = [line(relative(diagnostic)) for diagnostic in report.findings]
    if report.statistics:
        lines += [f"{count:>6}  {severity.value:<7} {code} {name}" for count, severity, code, name in counted(report)]
    return "".join(f"{text}\n" for text in lines)


def line(diagnostic: Diagnostic) -> str:
    """Return the line of a finding."""
    also = f" ({likewise(diagnostic)})" if diagnostic.also else ""
    return f"{place(diagnostic)}: {diagnostic.severity.value} {diagnostic.code} {visible(diagnostic.message + also)}"


def place(diagnostic: Diagnostic) -> str:
    """Return `file:line:column`."""
    at = diagnostic.at
    return f"{visible(at.file)}:{at.line}:{at.column}"
