"""The explanation of a fault, with its examples and the real output of lint."""

from __future__ import annotations

import os
import textwrap

from urdfctl.catalog.distros import in_words
from urdfctl.fault import Fault, Runtime
from urdfctl.lint.examples import written
from urdfctl.lint.findings.merging import merge
from urdfctl.lint.results import Report
from urdfctl.lint.selection import Selection
from urdfctl.lint.target import lint_target
from urdfctl.load.loader import Loader
from urdfctl.logs.printed import printed_because_of
from urdfctl.output.scratch import scratch_folder
from urdfctl.report.common import relative
from urdfctl.report.text import render
from urdfctl.rules import command_of


def fault_explanation(fault: Fault) -> str:
    """Return the fault's summary, reason, authority and first examples as text."""
    parts = [
        f"{fault.code} {fault.name} ({fault.severity.value}; {in_words(fault.distros)})",
        fault.summary,
        *(textwrap.fill(paragraph, 100) for paragraph in fault.why.split("\n\n")),
        runtime_of(fault),
        _printed(fault),
        textwrap.fill(f"Authority: {fault.authority}", 100),
    ]
    if fault.bad:
        parts += ["Wrong:", *_files(fault.bad[0].files)]
        if command_of(fault.code) == "lint":
            parts += ["Output of urdfctl lint:", textwrap.indent(output_of_lint(fault), "  ")]
        parts += ["Right:", *_files(fault.good[0].files)]
    parts.append(f"To ignore it in one place: <!-- urdfctl: ignore[{fault.code}] the reason -->")
    return "\n\n".join(part for part in parts if part) + "\n"


def runtime_of(fault: Fault) -> str:
    """Return what ROS or Gazebo does with the fault, and why the severity is not the usual one for that."""
    does = {
        Runtime.REFUSES: "rejects the part, or does not start or move it",
        Runtime.CRASHES: "ends with an error",
        Runtime.DROPS: "goes on without the part",
        Runtime.IGNORES: "ignores what is written",
        Runtime.MISBEHAVES: "does something else than what was meant",
        Runtime.WARNS: "warns and goes on",
        Runtime.WORKS: "works",
    }[fault.runtime]
    because = f"; {fault.severity.value}, because {fault.because}" if fault.because else ""
    return textwrap.fill(f"Runtime: {does}{because}.", 100)


def _printed(fault: Fault) -> str:
    """What the user may see of the fault in a log."""
    lines = [f"  {message.text} ({message.by})" for message in printed_because_of(fault.code)]
    return "\n".join(["Printed in the log because of it:", *lines]) if lines else ""


def _files(files: dict[str, str]) -> list[str]:
    shown = []
    for name, text in files.items():
        plain = text.replace("«", "").replace("»", "")
        shown.append(textwrap.indent(f"{name}:\n{textwrap.indent(plain.rstrip(), '  ')}", "  "))
    return shown


def output_of_lint(fault: Fault) -> str:
    """Return the real output of lint for the first bad example."""
    with scratch_folder() as made:
        folder = os.path.realpath(made)
        selection = Selection()
        target, settings = written(fault.bad[0], folder)
        linted = lint_target(Loader(settings), target, selection).result
        findings = (finding for finding in merge([linted.outcome], selection) if finding.code == fault.code)
        report = Report((), tuple(relative(finding, folder) for finding in findings))
        return "\n".join(render(report).splitlines()[:-1])
